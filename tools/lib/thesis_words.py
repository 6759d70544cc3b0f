# SPDX-License-Identifier: MIT
"""The words of the page of tools/thesis: what the thesis says of each figure and lesson, in our words.

Verdicts are not among them: tools/lib/thesis.py computes these."""
import typing


class Section(typing.NamedTuple):
    id: str  # of the experiment in tests/thesis
    title: str
    where: str  # figures and chapters of the thesis
    says: str  # what the thesis says
    shows: str  # what is measured here
    figures: tuple = ()  # numbers of its figures


SECTIONS = (
    Section(
        "climb", "A corner found by climbing", "figure 3.4, chapter 3.2.3",
        "Only one corner of a convex polygon is farther along a direction than both neighbours, so"
        " walking uphill finds it. Polygons are arranged with the sharpest corner first.",
        "Random hulls from convexHull(), climbed from their first corner, and again after"
        " arrange().", ("3.4",)),
    Section(
        "plate", "A contact point outside of a body", "figure 3.5, chapter 3.3.2",
        "The deepest corner is the contact point, even if it has left a thin body on its far side."
        " Such hits are best treated as single points; tunnelling itself is another problem.",
        "collide() of a box of 1 m and a plate of 5 cm, then boxes that fall on the plate at 2 to"
        " 200 m/s, 21 in all.", ("3.5",)),
    Section(
        "local", "Local space and degrees of freedom", "figures 2, 4.1 and 4.2, equation 4.5",
        "A point moves with the velocity of the centre plus the spin times its perpendicular arm."
        " A body in the plane has three degrees of freedom; flags lock two or one of them.",
        "The way of a corner in a short step, and an impulse on locked bodies.",
        ("2", "4.1", "4.2")),
    Section(
        "fork", "A compound without an average normal", "figure 4.3, chapter 4.1.4",
        "A compound keeps two points and averages their normals, which fails where they oppose"
        " each other, as for a fork over a wall.",
        "The fork falls over the wall. Kodo keeps one manifold for each pair of parts.", ("4.3",)),
    Section(
        "bisection", "The time of a collision", "figure 4.4, chapter 4.2.2",
        "Halving the step finds the time of a collision, at the price of many intersection tests,"
        " and fails for bodies that overlap at the start. So the thesis leaves it out.",
        "A ball at 100 m/s and a wall: halving with collide(), and the closed form of"
        " shapeCast().", ("4.4",)),
    Section(
        "pairwise", "A stack seen in pairs", "figure 4.5, chapter 4.2.2.2",
        "Collisions are solved in pairs. In a stack only the lowest box feels the floor at first;"
        " each iteration stops one box more, at least.",
        "The first step of ten boxes at rest, with more and more passes. A box has felt the floor"
        " if it falls slower than g h by 1 part in 1,000.", ("4.5",)),
    Section(
        "euler", "Euler's spiral", "figure 4.6, equation 4.8",
        "A pull towards a centre should keep a body on its circle. Euler’s method lets it spiral"
        " away, since each step goes along the tangent.",
        "A circle of 1 m in 2 s. Equation 4.8 is done with Kodo’s own bodies: a step without"
        " force, then the velocity of the old place. Beside it the same pull as a field, and a"
        " rod.", ("4.6",)),
    Section(
        "rates", "Smaller steps, smaller errors", "chapter 4.2.2.4",
        "A smaller time step gives a smaller cumulative error, so the step is split.",
        "Growth of Euler’s orbit at 30 to 480 Hz, against its exact law; and the error of a free"
        " fall in Kodo, whose steps are exact for a constant force."),
    Section(
        "impulse", "The collision", "figure 4.7, equation 4.9, chapter 4.3.3",
        "The impulse follows from the approach speed, masses, arms and moments of inertia. Of two"
        " restitutions the smaller one counts.",
        "A ball of restitution 1 hits a rod off its centre.", ("4.7",)),
    Section(
        "friction", "Two problems of friction", "chapter 4.3.3, equation 4.10",
        "In the thesis the friction of a collision depends on its restitution, and on the number"
        " of iterations. Rolling bodies must come to a halt.",
        "A box slides from 5 m/s to rest: with two restitutions, and with 4 to 40 passes. Both"
        " problems are gone if the way stays the same."),
    Section(
        "separation", "Separation", "figure 4.8, chapters 4.3.4 and 6.1",
        "Overlapping bodies move apart at the end of a step, by equal amounts, and not completely."
        " A locked body stays. Later this should be done by impulses.",
        "Two boxes that overlap by 20 cm, without gravity, for 2 s.", ("4.8",)),
    Section(
        "shock", "Shock propagation on and off", "chapter 4.2.2.2, appendix A",
        "Collisions solved from the lowest up, with the lower body as if of infinite mass, steady"
        " tall stacks even with few iterations.",
        "A tower of twelve boxes with 2 passes, without and with 2 shock passes: the first lesson"
        " of Destructoooor!, whose scenes these are. Then a heavy box on light ones.", ("A.1",)),
    Section(
        "iterations", "Iterations against overlap", "appendix A",
        "Overlap grows with load and with the size of a stack. More iterations counter it.",
        "A pyramid with 2 to 80 passes, and towers of 2 to 16 boxes: the second lesson of"
        " Destructoooor!.", ("A.1",)),
    Section(
        "stacks", "Get stacking to work", "chapters 4.3 and 6",
        "It matters more that bodies can stack and rest than that those in flight are exact.",
        "Stacks of 3, 10 and 20 boxes at three step rates, without sleep, so that nothing but the"
        " solver holds them."),
    Section(
        "order", "A random order of collisions", "chapter 4.2.2.3",
        "Solving in one order has a bias. A stride that shares no factor with the length of the"
        " list gives a new order each time.",
        "A symmetric pyramid: its boxes should drift to neither side."),
    Section(
        "sweep", "Sort and sweep", "figures 5.1 and 5.2, chapter 5.1.1",
        "Ten bodies in a flat row need 45 tests along the wrong axis and none along the right one."
        " The axis with more cells tagged is taken.",
        "The sort and sweep of the thesis, which serves the tests as a witness, and Kodo’s own"
        " trees of bounds.", ("5.1", "5.2")),
    Section(
        "resting", "Resting costs nothing", "chapter 5.2",
        "Bodies that have been calm for some frames rest, and are skipped. Taking a support away"
        " wakes what leans on it.",
        "Stacks of five boxes, side by side: bodies that a step works on."),
    Section(
        "tipping", "Slightly off balance", "figure 5.3, chapter 5.2.1",
        "A body that is hardly off its balance gains so little speed that it may be taken for"
        " resting, and freeze.",
        "A box of 0.4 m and 2 m on its corner, off its balance by 0.03 to 0.0003 rad. Its time is"
        " compared with that of a pendulum upside down.", ("5.3",)),
    Section(
        "leaveout", "Parts of the step left out", "chapter 4.2.2.1",
        "A set of flags leaves out parts of a step.",
        "Bodies that do not need a part, with and without it. Shares of CPU time are medians of"
        " runs in turn, not judged, and differ between machines and runs. What parts cost where"
        " they are used is in engine/docs/features.md."),
    Section(
        "apart", "aPart", "figure A.2, appendix A",
        "Blocks break in several ways and fall off. Some parts attach to the paddle, others stick"
        " for a second and fire upwards; one kind of block becomes further balls. The ball must"
        " not halt in mid-air.",
        "The rules of the game aPart in this repository, played by script without a screen.",
        ("A.2",)),
)

# Figures of the thesis that have no section: why.
OTHERS = {
    "1": "a screenshot of another game",
    "3.1 to 3.3": "drawings of chapter 3 that go with definitions; tests/shapes and tests/collide"
                  " hold what they say",
}
FIGURES = ("1", "2", "3.4", "3.5", "4.1", "4.2", "4.3", "4.4", "4.5", "4.6", "4.7", "4.8", "5.1",
           "5.2", "5.3", "A.1", "A.2")
