#include "collision_hulls/scene/configurations.h"

#include "scene/low_discrepancy.h"

namespace collision_hulls {

ConfigurationSequence::ConfigurationSequence(const Kinematics& kinematics, std::uint64_t seed, Sampling sampling)
    : variables_(kinematics.variables()), step_(richtmyerSteps(variables_.size())), sampling_(sampling) {
  for (std::size_t i = 0; i < variables_.size(); ++i) start_.push_back(mixed(mixed(seed) + i));
}

Configuration ConfigurationSequence::operator()(std::uint64_t index) const {
  Configuration result;
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    const std::uint64_t fraction = sampling_ == Sampling::kEven ? start_[i] + index * step_[i] : mixed(start_[i] ^ mixed(index));
    result.push_back(variables_[i].lower + toUnit(fraction) * (variables_[i].upper - variables_[i].lower));
  }
  return result;
}

}  // namespace collision_hulls
