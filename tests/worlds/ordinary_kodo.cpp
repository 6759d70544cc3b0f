// SPDX-License-Identifier: MIT
#include <worlds/judges.hpp>
#include <worlds/ordinary.hpp>

namespace worlds {
namespace {

using namespace kodo;

class KodoEngine final : public OrdinaryEngine {
public:
    explicit KodoEngine(const Recipe& recipe) : dt_(recipe.dt), scene_(build(recipe)) {}

    void step() override { scene_.world.step(dt_); }

    Motion motion(std::size_t body) const override {
        const BodyView view = scene_.world[scene_.ids[body]];
        return {toDouble(view.position()), toDouble(view.rotation()), toDouble(view.velocity()),
                static_cast<double>(view.angularVelocity())};
    }

private:
    Real dt_;
    Scene scene_;
};

} // namespace

std::unique_ptr<OrdinaryEngine> ordinaryInKodo(const Recipe& recipe) {
    return std::make_unique<KodoEngine>(recipe);
}

} // namespace worlds
