// SPDX-License-Identifier: MIT
#include "joints/joint_lists.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {

void JointLists::clear() {
    first_.clear();
    ends_.clear();
}

void JointLists::add(std::uint32_t joint, std::uint32_t a, std::uint32_t b) {
    if (ends_.size() < 2 * (std::size_t{joint} + 1)) {
        ends_.resize(2 * (std::size_t{joint} + 1));
    }
    link(2 * joint, a);
    if (a != b) {
        link(2 * joint + 1, b);
    }
}

void JointLists::remove(std::uint32_t joint) {
    unlink(2 * joint);
    unlink(2 * joint + 1);
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

void JointLists::link(std::uint32_t end, std::uint32_t body) {
    if (first_.size() <= body) {
        first_.resize(std::size_t{body} + 1, kNone);
    }
    const std::uint32_t next = first_[body];
    ends_[end] = {body, next, kNone};
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
