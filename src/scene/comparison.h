// The fitted model beside others of the same trees, and the meshes, on the samples that verify.
#pragma once

#include "scene/fit_report.h"

namespace collision_hulls {

/// original, single_hull, uniform cuts at shares of the clearance, the coarsest uniform cut that no sample refutes, those of the
/// fitting included ("uniform_adequate"), the one that is adequate by its bound alone ("uniform_proved": half the clearance), fitted,
/// fitted_hulls (with hulls in the primitives' places, where there may be any), finest.
std::vector<ModelRow> comparison(const FittedModel& model, const RunControl& control);

}  // namespace collision_hulls
