// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/contacts/contact.hpp>

namespace kodo::inline KODO_PRECISION {

/// Fills in what follows from its key and the definitions of its bodies.
void describeContact(Contact& contact, const Bodies& bodies);

/// Begins a step with the manifold of the last one, whose moves Motion still holds, of two parts
/// that are near each other. False if it does not do any more and must be found anew. Where it
/// carries the manifold on, it also measures the approach, by the levers that it needs anyway; but
/// if the contact `wentOn` while it was lent, both has been done.
bool followContact(Contact& contact, const Bodies& bodies, const Tolerances& tolerances,
                   bool wentOn);

/// Have the bodies of a contact gone so far (m) against each other that its manifold must be found
/// anew?
bool isOutdated(Real drift, bool bounces, const Tolerances& tolerances);

/// Finds where they touch. The contact must not be lent: its impulses go on to the new points.
void findContact(Contact& contact, const Bodies& bodies, const Tolerances& tolerances);

/// How fast its bodies approach now (m/s), for the record and for the impacts.
void measureApproach(Contact& contact, const Bodies& bodies);

/// What was pushed in the last step is not for the record of another.
void forgetBlows(Contact& contact);

/// Are its impulses finite, and where it is?
bool isSound(const Contact& contact);

/// The parts are not near any more: nothing is left of what was.
void clearContact(Contact& contact);

} // namespace kodo::inline KODO_PRECISION
