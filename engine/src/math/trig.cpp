// SPDX-License-Identifier: MIT
#include "math/trig.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

template KODO_API SinCos<float> sinCos(float radians);
template KODO_API SinCos<double> sinCos(double radians);
template KODO_API SinCos<long double> sinCos(long double radians);
template KODO_API float atan2(float y, float x);
template KODO_API double atan2(double y, double x);
template KODO_API long double atan2(long double y, long double x);

} // namespace KODO_PRECISION
} // namespace kodo
