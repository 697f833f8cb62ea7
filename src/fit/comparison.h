// Compares the fitted model with other cuts through the same trees, and with the meshes, on the verification samples.
#pragma once

#include "fit/fit_report.h"

namespace collision_hulls {

/// Rows: original; single_hull; uniform cuts at multiples of the clearance; uniform_proved, adequate by its bound alone (half the
/// clearance); uniform_adequate, the coarsest uniform cut that no sample refutes, counterexamples of the fit included; fitted; fitted_hulls
/// (hulls in place of primitives, if primitives are allowed); finest.
std::vector<ModelRow> comparison(const FittedModel& model, const RunControl& control);

}  // namespace collision_hulls
