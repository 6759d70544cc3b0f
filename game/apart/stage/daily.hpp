// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/daily.hpp>
