// SPDX-License-Identifier: MIT
#include "bodies/joint_lists.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {

void JointLists::clear() {
    lists_.clear();
    pairs_.clear();
    size_ = 0;
}

void JointLists::add(std::uint32_t joint, std::uint32_t a, std::uint32_t b, bool excludes) {
    pairs_.resize(std::max(pairs_.size(), joint + std::size_t{1}));
    pairs_[joint] = {a, b, excludes};
    lists_.add(joint, a, b);
    size_ += 1;
}

void JointLists::remove(std::uint32_t joint) {
    const Pair& pair = pairs_[joint];
    lists_.remove(joint, pair.a, pair.b);
    size_ -= 1;
}

bool JointLists::exclude(std::uint32_t a, std::uint32_t b) const {
    const auto excludes = [&](std::uint32_t joint, std::uint32_t other) {
        const Pair& pair = pairs_[joint];
        return pair.excludes && (pair.a == other || pair.b == other);
    };
    std::uint32_t linkA = lists_.firstOf(a);
    std::uint32_t linkB = lists_.firstOf(b);
    while (a != b && linkA != PairLists::kEnd && linkB != PairLists::kEnd) {
        if (excludes(linkA / 2, b) || excludes(linkB / 2, a)) {
            return true;
        }
        linkA = lists_.after(linkA);
        linkB = lists_.after(linkB);
    }
    return false;
}

void JointLists::list(std::uint32_t body, std::vector<std::uint32_t>& joints) const {
    joints.clear();
    forEach(body, [&](std::uint32_t joint) { joints.push_back(joint); });
    std::sort(joints.begin(), joints.end()); // total order: joints are unique
}

std::vector<std::uint32_t> JointLists::of(std::uint32_t body) const {
    std::vector<std::uint32_t> joints;
    list(body, joints);
    return joints;
}

} // namespace KODO_PRECISION
} // namespace kodo
