// SPDX-License-Identifier: MIT
#include "bodies/joint_lists.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {

void JointLists::clear() {
    first_.clear();
    ends_.clear();
    size_ = 0;
    excluding_ = 0;
}

void JointLists::add(std::uint32_t joint, std::uint32_t a, std::uint32_t b, bool excludes) {
    if (ends_.size() < 2 * (std::size_t{joint} + 1)) {
        ends_.resize(2 * (std::size_t{joint} + 1));
    }
    link(2 * joint, a, excludes);
    if (a != b) {
        link(2 * joint + 1, b, excludes);
    }
    size_ += 1;
    excluding_ += excludes ? 1 : 0;
}

void JointLists::remove(std::uint32_t joint) {
    size_ -= 1;
    excluding_ -= ends_[2 * std::size_t{joint}].excludes ? 1 : 0;
    unlink(2 * joint);
    unlink(2 * joint + 1);
}

bool JointLists::exclude(std::uint32_t a, std::uint32_t b) const {
    if (a == b || !hasAny(a) || !hasAny(b)) {
        return false;
    }
    std::uint32_t endA = first_[a];
    std::uint32_t endB = first_[b];
    while (endA != kNone && endB != kNone) {
        if ((ends_[endA].excludes && ends_[endA ^ 1u].body == b) ||
            (ends_[endB].excludes && ends_[endB ^ 1u].body == a)) {
            return true;
        }
        endA = ends_[endA].next;
        endB = ends_[endB].next;
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

void JointLists::link(std::uint32_t end, std::uint32_t body, bool excludes) {
    if (first_.size() <= body) {
        first_.resize(std::size_t{body} + 1, kNone);
    }
    const std::uint32_t next = first_[body];
    ends_[end] = {body, next, kNone, excludes};
    if (next != kNone) {
        ends_[next].before = end;
    }
    first_[body] = end;
}

void JointLists::unlink(std::uint32_t end) {
    const End old = ends_[end];
    if (old.body == kNone) {
        return;
    }
    if (old.before != kNone) {
        ends_[old.before].next = old.next;
    } else {
        first_[old.body] = old.next;
    }
    if (old.next != kNone) {
        ends_[old.next].before = old.before;
    }
    ends_[end] = {};
}

} // namespace KODO_PRECISION
} // namespace kodo
