// SPDX-License-Identifier: MIT
#include <apart/core/standing_trial.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace apart {

StandingTrial::StandingTrial(std::shared_ptr<const Level> level) : game_(std::move(level), 1) {
    std::copy_if(game_.blocks().begin(), game_.blocks().end(), std::back_inserter(blocks_),
                 [](const Block& block) { return block.support == Support::Standing; });
}

void StandingTrial::advance(std::uint32_t ticks) {
    for (std::uint32_t i = 0; i < ticks && !done(); ++i) {
        game_.tick({});
        for (const Block& block : blocks_) {
            const bool gone = !game_.world().contains(block.body);
            const kodo::Real way =
                gone ? kFieldHeight
                     : length(game_.world()[block.body].position() - block.home.position);
            if (way > (farthest_ ? farthest_->way : kStill)) {
                farthest_ = {block, game_.ticks(), way};
                first_ = first_ ? first_ : farthest_;
            }
        }
    }
}

} // namespace apart
