#pragma once

#include "src/kernels/contacts/contact_kernels.h"
#include "src/layered/solve/contact_batches.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Of the speed that gravity adds in a step: a contact is not solved again for changes of motion no larger than this.
/// Measured: with 1e-8 a tower of 40 that never sleeps sways by 70 micrometres in a minute, with 1e-9 by half of one.
inline constexpr double kStillPart = 1e-9;

/// Solves all layers as often as their group says; they hold, and fast pairs do so too or push (sweep: kHold or kPush).
/// The first sweep goes in direction `first`, the next in the opposite direction, and so on. The manifolds of a layer
/// read the velocities from before the layer, and the layer adds up their outcomes as grid doubles, so the result does
/// not depend on the order within a layer.
void sweep_layers(Scratch& scratch, Sweep sweep, Direction first, double substep_s);

/// The deepest overlap beyond the slop, m; 0 if nothing overlaps. Begins sweep_overlaps: contacts that do not overlap
/// count as solved, since they part nothing while their bodies rest.
double find_overlaps(Scratch& scratch, const ContactWork& all);

/// Sweeps the contacts `all`, whose work names other points and bodies than those of the step, so that overlaps part:
/// `more` times than the groups say.
void sweep_overlaps(Scratch& scratch, const ContactWork& all, int more);

/// Applies the impulses that the contacts already have.
void warm_start_layers(Scratch& scratch, double substep_s);

/// Goes on with the push where what bounces in a fast pair touches anything else: else that would go on into it until
/// the bounce takes it along.
void end_fast_push(Scratch& scratch, double substep_s);

/// Make the contacts of fast pairs bounce, and those of layers. First the push is ended. Then what bounces and what it
/// touches, directly or by others, are solved by turns, so that all of it is taken along. The former returns whether
/// bodies of fast pairs touch anything else.
bool bounce_fast_layer(const Bodies& bodies, Scratch& scratch, double substep_s);
void bounce_layers(Scratch& scratch, double dt_s);

}  // namespace tumble::sim
