// Best-first search for each pair:
//
//   boxes = {all joint values; both bodies swept over all their joints}
//   until the box with the least bound is far enough apart, take that box:
//     if the swept bodies are too near at its middle, unsweep one joint of the body that shrinks more by it
//     otherwise halve the box along the variable that moves the bodies most
//     bound the boxes that result
#include "collision_hulls/reach/reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <queue>
#include <string>

#include "base/counted.h"
#include "base/decimal.h"
#include "base/random.h"
#include "collision_hulls/error.h"
#include "reach/box_movement.h"
#include "reach/obstacle.h"
#include "reach/reach_ball.h"
#include "reach/sweep.h"
#include "scene/low_discrepancy.h"

namespace collision_hulls {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9;                         // of the coordinates' size, subtracted from each bound
constexpr std::size_t kSamples = 200;                      // configurations tried first: nearly all pairs that touch do so in one of them
constexpr std::size_t kSamplesOfFar = 20;                  // the same, for pairs that are proved at once
constexpr double kCloser = 0.97;                           // factor on the range of the search around the best sample, after each failure
constexpr std::uint64_t kMiddle = std::uint64_t{1} << 63;  // start of the samples, as a fraction of 2^64
constexpr double kShareToTighten = 0.2;                    // of the evaluations, for use after the proof
constexpr double kWorthHalving = 0.05;  // of the movement within a box: a box is halved if its gap exceeds the target by more than this

/// A link and the joints that move it.
struct MovedLink {
  ConvexHull hull;
  Chain chain;
  double size = 0;  // [m] upper bound on the distance of its points from the root's origin
  mutable std::once_flag once;
  mutable std::vector<PointMatrix> bodies;  // see sweeps(); made on first use
};

/// One side of a pair: a link, which its joints after the first `common` ones move relative to the other side.
struct Side {
  const MovedLink* link = nullptr;
  std::size_t common = 0;

  std::size_t joints() const { return link->chain.joints.size(); }
  const ChainJoint& joint(std::size_t k) const { return link->chain.joints[k]; }
  const PointMatrix& body(std::size_t level) const { return link->bodies[level]; }
};

/// A box of joint values, and how many joints of each side are not swept.
struct Box {
  std::vector<JointRange> variables;  // of the pair
  std::array<std::size_t, 2> levels{};
  double gap = 0;          // [m] lower bound on the gap between the bodies at the middle
  double movement = 0;     // [m] upper bound on the movement of their points within the box
  double bound = 0;        // [m] lower bound on the distance within the box
  std::size_t widest = 0;  // the variable that moves the bodies most
  std::size_t number = 0;
};
struct Later {
  bool operator()(const Box& a, const Box& b) const { return a.bound > b.bound || (a.bound == b.bound && a.number > b.number); }
};

double middle(const JointRange& range) {
  return (range.lower + range.upper) / 2;
}

/// The search for one pair.
class PairSearch {
 public:
  PairSearch(const Kinematics& kinematics, std::vector<Side> sides, const Obstacle* obstacle, double clearance, const ReachOptions& options,
             const RunControl& control)
      : kinematics_(kinematics), sides_(std::move(sides)), obstacle_(obstacle), options_(options), control_(control), target_(clearance) {
    position_.assign(kinematics.variables().size(), -1);
    double size = obstacle ? obstacle->size() : 0;
    for (const Side& side : sides_) {
      size = std::max(size, side.link->size);
      for (std::size_t k = side.common; k < side.joints(); ++k) addVariable(side.joint(k).variable);
    }
    rounding_ = kRounding * size;
    result_.found = kInfinity;
  }

  Reach run() {
    push(wholeBox());
    sample(open_.top().bound > target_ ? kSamplesOfFar : kSamples);
    const double clearance = target_;
    search(options_.evaluations);
    if (result_.outcome == Reach::Outcome::kUnknown && open_.top().bound > clearance) {
      result_.outcome = Reach::Outcome::kProved;
      target_ = std::max(clearance, options_.tightness * result_.found);
      const auto more = static_cast<std::size_t>(kShareToTighten * static_cast<double>(options_.evaluations));
      search(std::min(options_.evaluations, result_.evaluations + more));
    }
    result_.bound = std::max(0.0, open_.top().bound);
    return result_;
  }

 private:
  void addVariable(std::size_t variable) {
    if (position_[variable] >= 0) return;
    position_[variable] = static_cast<int>(variables_.size());
    variables_.push_back(variable);
  }

  Box wholeBox() const {
    Box box;
    for (const std::size_t v : variables_) box.variables.push_back({kinematics_.variables()[v].lower, kinematics_.variables()[v].upper});
    box.levels = {sides_.front().common, sides_.back().common};
    return box;
  }

  /// Whether neither body is swept.
  bool isFinal(const Box& box) const {
    for (std::size_t s = 0; s < sides_.size(); ++s) {
      if (box.levels[s] < sides_[s].joints()) return false;
    }
    return true;
  }

  /// Tries configurations all over the joints' ranges, then around the nearest of them, ever closer.
  void sample(std::size_t most) {
    const Box whole = wholeBox();
    const std::vector<std::uint64_t> steps = richtmyerSteps(variables_.size());
    const std::size_t count = variables_.empty() ? 1 : std::min(most, options_.evaluations);
    double radius = 1;  // of the ranges
    for (std::size_t i = 0; i < count && result_.found > target_; ++i) {
      const bool all_over = 2 * i < count || result_.witness.empty();
      Box point = whole;
      for (std::size_t s = 0; s < sides_.size(); ++s) point.levels[s] = sides_[s].joints();
      for (std::size_t v = 0; v < variables_.size(); ++v) {
        const JointRange& range = whole.variables[v];
        const double share = unitInterval(steps[v] * i + kMiddle), length = range.upper - range.lower;
        const double at = all_over ? range.lower + share * length : result_.witness[variables_[v]] + radius * (share - 0.5) * length;
        point.variables[v].lower = point.variables[v].upper = std::clamp(at, range.lower, range.upper);
      }
      const double found = result_.found;
      bound(point);
      if (!all_over && result_.found >= found) radius *= kCloser;
    }
  }

  /// Runs until the least bound is above the target, the evaluations run out, or the pair touches.
  void search(std::size_t evaluations) {
    while (open_.top().bound <= target_ && result_.evaluations < evaluations) {
      control_.check();
      if (result_.found <= target_ && result_.outcome == Reach::Outcome::kUnknown) {
        result_.outcome = Reach::Outcome::kTouched;
        return;
      }
      const Box box = open_.top();
      const bool final_box = isFinal(box);
      if (final_box && box.movement <= 0) return;  // nothing can improve the bound
      open_.pop();
      if (final_box || (box.movement > 0 && box.gap - target_ > kWorthHalving * box.movement)) {
        halve(box);
      } else {
        handOn(box);
      }
    }
  }

  void halve(const Box& box) {
    const JointRange whole = box.variables[box.widest];
    for (const JointRange& half : {JointRange{whole.lower, middle(whole)}, JointRange{middle(whole), whole.upper}}) {
      Box part = box;
      part.variables[box.widest] = half;
      push(std::move(part));
    }
  }

  /// Takes one more joint out of the sweep, on the side whose body shrinks more by it.
  void handOn(Box box) {
    std::size_t best = 0;
    double most = -kInfinity;
    for (std::size_t s = 0; s < sides_.size(); ++s) {
      if (box.levels[s] >= sides_[s].joints()) continue;
      const double shrinks = extent(sides_[s].body(box.levels[s])) - extent(sides_[s].body(box.levels[s] + 1));
      if (shrinks > most) most = shrinks, best = s;
    }
    ++box.levels[best];
    push(std::move(box));
  }

  static double extent(const PointMatrix& points) { return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm(); }

  void push(Box box) {
    bound(box);
    box.number = pushed_++;
    open_.push(std::move(box));
  }

  /// Bounds the distance within a box from the distance at its middle.
  void bound(Box& box) {
    std::vector<BoxedBody> bodies;
    for (std::size_t s = 0; s < sides_.size(); ++s) bodies.push_back(boxed(s, box));
    std::vector<double> shares(variables_.size(), 0);
    box.movement = 0;
    for (const BoxedBody& body : bodies) box.movement += body.movement(shares);
    const double enough = box.movement > 0 ? target_ + box.movement + rounding_ : kInfinity;
    const Gap gap = gapOf(bodies, enough);
    ++result_.evaluations;
    if (gap.at_least < enough && !gap.direction.isZero()) {
      // Only movement towards each other counts, which near a minimum of the distance is far less.
      std::fill(shares.begin(), shares.end(), 0);
      box.movement = bodies.front().movementAlong(-gap.direction, shares);
      if (bodies.size() > 1) box.movement += bodies.back().movementAlong(gap.direction, shares);
    }
    box.gap = gap.at_least;
    box.bound = std::max(box.bound, gap.at_least - box.movement - rounding_);
    box.widest = static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin());
    if (isFinal(box) && gap.at_most < result_.found) {
      result_.found = gap.at_most;
      result_.witness = kinematics_.rest();
      for (std::size_t v = 0; v < variables_.size(); ++v) result_.witness[variables_[v]] = middle(box.variables[v]);
    }
  }

  BoxedBody boxed(std::size_t s, const Box& box) const {
    const Side& side = sides_[s];
    std::vector<BoxedJoint> joints;
    for (std::size_t k = side.common; k < box.levels[s]; ++k) {
      const ChainJoint& joint = side.joint(k);
      const auto variable = static_cast<std::size_t>(position_[joint.variable]);
      const JointRange& range = box.variables[variable];
      joints.push_back({&joint, variable, joint.multiplier * middle(range) + joint.offset,
                        std::abs(joint.multiplier) * (range.upper - range.lower) / 2});
    }
    return {side.body(box.levels[s]), std::move(joints)};
  }

  Gap gapOf(const std::vector<BoxedBody>& bodies, double enough) const {
    return obstacle_ ? obstacle_->gapTo(bodies[0].points(), enough) : convexGap(bodies[0].points(), bodies[1].points(), enough);
  }

  const Kinematics& kinematics_;
  const std::vector<Side> sides_;
  const Obstacle* const obstacle_;
  const ReachOptions& options_;
  const RunControl& control_;
  std::vector<std::size_t> variables_;  // that move the pair
  std::vector<int> position_;           // of a variable among them
  double rounding_ = 0;
  double target_ = 0;
  std::priority_queue<Box, std::vector<Box>, Later> open_;
  std::size_t pushed_ = 0;
  Reach result_;
};

void expectIndex(const std::string& what, std::size_t index, std::size_t count) {
  if (index < count) return;
  throw Error(ErrorCode::kIndexOutOfRange,
              "there is no " + what + " " + std::to_string(index) + ": there are " + std::to_string(count) + ", counted from 0");
}

/// [m] Upper bound on how far a link's points get from the root's origin.
double reachOf(const ConvexHull& hull, const Chain& chain, const std::vector<JointVariable>& variables) {
  double radius = 0;
  for (const Eigen::Vector3d& v : hull.vertices) radius = std::max(radius, v.norm());
  const ReachBall ball = reachBall(chain, variables, radius);
  return ball.centre.norm() + ball.radius;
}

}  // namespace

struct ReachProver::Impl {
  Impl(const Kinematics& the_kinematics, const std::vector<ConvexHull>& hulls, const Scene& scene)
      : kinematics(the_kinematics), links(hulls.size()) {
    if (hulls.size() != kinematics.links())
      throw Error(ErrorCode::kIndexOutOfRange, "there are hulls of " + counted(hulls.size(), "link") + ", but the robot has " +
                                                   std::to_string(kinematics.links()) + "; give one for each, without vertices where a " +
                                                   "link has no geometry");
    for (std::size_t i = 0; i < hulls.size(); ++i) {
      links[i].hull = hulls[i];
      links[i].chain = kinematics.chain(i);
      links[i].size = reachOf(hulls[i], links[i].chain, kinematics.variables());
    }
    for (const SceneBody& body : scene.bodies) obstacles.emplace_back(body);
  }

  /// Null if the link has no geometry.
  const MovedLink* link(std::size_t index) const {
    expectIndex("link", index, links.size());
    const MovedLink& link = links[index];
    if (link.hull.vertices.empty()) return nullptr;
    std::call_once(link.once, [&] { link.bodies = sweeps(link.hull, link.chain, kinematics.variables()); });
    return &link;
  }

  const Kinematics kinematics;
  std::vector<MovedLink> links;
  std::vector<Obstacle> obstacles;
};

ReachProver::ReachProver(const Kinematics& kinematics, const std::vector<ConvexHull>& links, const Scene& scene)
    : impl_(std::make_unique<Impl>(kinematics, links, scene)) {}
ReachProver::~ReachProver() = default;
ReachProver::ReachProver(ReachProver&&) noexcept = default;

namespace {

Reach neverNear() {
  return {Reach::Outcome::kProved, kInfinity, kInfinity, {}, 0};
}

/// Throws kBadOption.
void check(double clearance, const ReachOptions& options) {
  if (!(clearance >= 0 && clearance < kInfinity)) {
    throw Error(ErrorCode::kBadOption, "the clearance is " + fixedDecimal(clearance) + " m; it must be finite and at least 0");
  }
  if (options.evaluations < 1 || !(options.tightness > 0 && options.tightness < 1)) {
    throw Error(ErrorCode::kBadOption, "evaluations is " + std::to_string(options.evaluations) + " and tightness is " +
                                           fixedDecimal(options.tightness) +
                                           "; evaluations must be at least 1, and tightness between 0 and 1");
  }
}

}  // namespace

Reach ReachProver::betweenLinks(std::size_t link, std::size_t other, double clearance, const ReachOptions& options,
                                const RunControl& control) const {
  check(clearance, options);
  const MovedLink *first = impl_->link(link), *second = impl_->link(other);
  if (!first || !second) return neverNear();
  const std::vector<ChainJoint>&a = first->chain.joints, &b = second->chain.joints;
  std::size_t common = 0;  // joints shared by both chains do not move the pair
  while (common < std::min(a.size(), b.size()) && equalJoints(a[common], b[common])) ++common;
  return PairSearch(impl_->kinematics, {{first, common}, {second, common}}, nullptr, clearance, options, control).run();
}

Reach ReachProver::betweenLinkAndBody(std::size_t link, std::size_t body, double clearance, const ReachOptions& options,
                                      const RunControl& control) const {
  check(clearance, options);
  expectIndex("body of the scene", body, impl_->obstacles.size());
  const MovedLink* moved = impl_->link(link);
  if (!moved) return neverNear();
  return PairSearch(impl_->kinematics, {{moved, 0}}, &impl_->obstacles[body], clearance, options, control).run();
}

}  // namespace collision_hulls
