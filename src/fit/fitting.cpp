// The loop of fit.h, steps 3 to 6. Batches grow, as the first samples find most counterexamples at little cost. Samples for searching come
// from a low-discrepancy sequence; those that verify are independent, since a rate is concluded from them.
#include "fit/fitting.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "base/parallel.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kFirstBatch = 256;  // samples; each further batch is twice as large
constexpr std::size_t kMostRounds = 12;   // over the same samples, and of verification

struct Answer {
  std::vector<Contact> current, roots;
  bool at_leaves = false;
};

}  // namespace

bool isClear(const Originals& originals, const CheckedPairs& pairs, const Places& places) {
  std::vector<PartPair> near;
  for (const std::size_t i : pairs.near(originals.boxesOfLinks(places), pairs.clearance())) near.push_back(pairs.all()[i]);
  std::stable_sort(near.begin(), near.end(), [](const PartPair& a, const PartPair& b) { return urgency(a) > urgency(b); });
  return std::all_of(near.begin(), near.end(), [&](const PartPair& pair) {
    return originals.distanceBelow(pair.clearance, pair.a, pair.b, places) >= pair.clearance;
  });
}

/// Whether the originals of some parts touch. As the model covers the original, only parts that touch in the model can. It takes FCL a
/// hundredth of the time of a distance.
bool Fitting::touch(const std::set<PartIndices>& parts, const Places& places) const {
  return std::any_of(parts.begin(), parts.end(), [&](const PartIndices& p) { return originals_.touch(p.first, p.second, places); });
}

Answers Fitting::ask(const std::vector<std::size_t>& samples) const {
  std::vector<Answer> answers(samples.size());
  forEach(samples.size(), [&](std::size_t i) {
    control_.check();
    const Places places = assembly_.places(samples[i]);
    std::vector<Contact> current = contacts(assembly_, hull_cuts_, pairs_, places, samples[i]);
    if (current.empty() || touch(partsOf(assembly_, current), places) || !isClear(originals_, pairs_, places)) return;
    Answer& answer = answers[i];
    answer.at_leaves = std::any_of(current.begin(), current.end(), [&](const Contact& c) { return touchesAtLeaves(assembly_, c); });
    answer.roots = contacts(assembly_, assembly_.roots(), pairs_, places, samples[i]);
    answer.current = std::move(current);
  });
  Answers all;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const Answer& answer = answers[i];
    if (answer.current.empty()) continue;
    if (answer.at_leaves) {
      all.leaves.push_back(answer.current.front());
      continue;
    }
    all.samples.push_back(samples[i]);
    all.current.insert(all.current.end(), answer.current.begin(), answer.current.end());
    all.roots.insert(all.roots.end(), answer.roots.begin(), answer.roots.end());
  }
  return all;
}

/// Evaluates samples and cures their counterexamples; returns the number of these.
std::size_t Fitting::cure(const std::vector<std::size_t>& samples) {
  const Answers answers = ask(samples);
  const bool again = !problem_.configurations.empty() && !asked_.empty();
  if (!again) asked_.insert(asked_.end(), samples.begin(), samples.end());
  leaves_ = answers.leaves;
  roots_.insert(roots_.end(), answers.roots.begin(), answers.roots.end());
  seen_.insert(seen_.end(), answers.roots.begin(), answers.roots.end());
  seen_.insert(seen_.end(), answers.current.begin(), answers.current.end());
  if (!answers.samples.empty()) {
    Curing curing(assembly_, hull_cuts_);
    curing.add(answers.current);
    curing.run(control_);
    takeHulls(curing.cuts());
  }
  progress_ += (1 - progress_) / 8;
  control_.report(progress_);
  return answers.samples.size();
}

/// Takes over a finer cut; hulls that primitives replaced before stay replaced.
void Fitting::takeHulls(const Cuts& cuts) {
  hull_cuts_ = cuts;
  for (std::size_t i = 0; i < cuts_.size(); ++i) {
    const DetailTree& tree = *assembly_.pieces()[i].tree;
    std::vector<int> nodes = cuts[i];
    for (const int before : cuts_[i]) std::replace(nodes.begin(), nodes.end(), tree.hull(before), before);
    cuts_[i] = nodes;
  }
}

/// Evaluates samples and takes back primitives that collide where the hulls do not; returns the number of such samples. Pairs proved apart
/// are checked, too: a primitive may protrude beyond the hull that the proof is about.
std::size_t Fitting::refute(const std::vector<std::size_t>& samples) {
  const CheckedPairs pairs(assembly_, lookedAtAndProved(rules_, options_.clearance));
  std::vector<std::vector<Contact>> found(samples.size());
  forEach(samples.size(), [&](std::size_t i) {
    control_.check();
    const Places places = assembly_.places(samples[i]);
    if (!inContact(assembly_, hull_cuts_, pairs, places)) found[i] = contacts(assembly_, cuts_, pairs, places, samples[i]);
  });
  std::vector<Contact> all;
  for (const std::vector<Contact>& current : found) all.insert(all.end(), current.begin(), current.end());
  Curing curing(assembly_, cuts_, Curing::Opens::kPrimitives);
  curing.add(all);
  curing.run(control_);
  cuts_ = curing.cuts();
  return static_cast<std::size_t>(std::count_if(found.begin(), found.end(), [](const auto& current) { return !current.empty(); }));
}

/// Evaluates the next samples, or all given configurations, with hulls and primitives; returns the number of counterexamples.
std::size_t Fitting::cureBatch(std::size_t count) {
  const std::size_t given = problem_.configurations.size();
  std::vector<std::size_t> samples(given > 0 ? given : count);
  std::iota(samples.begin(), samples.end(), given > 0 ? 0 : next_);
  verified_from_ = samples.front();
  next_ += samples.size();
  std::size_t found = cure(samples);
  if (!cuts_.empty()) found += refute(samples);
  cured_ += found;
  return found;
}

/// Step 3. Small batches first: they find most counterexamples, at little cost.
void Fitting::cureGrowingBatches() {
  if (!problem_.configurations.empty()) {
    cureBatch(problem_.configurations.size());
    return;
  }
  for (std::size_t count = kFirstBatch; count < options_.samples; count *= 2) cureBatch(count);
}

/// Step 4. With all counterexamples known, starts over from the roots; keeps whichever result has fewer hulls.
void Fitting::fitAll() {
  Curing curing(assembly_, assembly_.roots());
  curing.add(roots_);
  curing.run(control_);
  const Cuts again = closed(assembly_, curing.cuts(), roots_, control_), mended = closed(assembly_, hull_cuts_, roots_, control_);
  hull_cuts_ = assembly_.hulls(again) <= assembly_.hulls(mended) ? again : mended;
}

/// Step 5. A primitive that replaces another may touch where that one did not, so the same samples are evaluated until nothing changes.
void Fitting::usePrimitives() {
  cuts_ = assembly_.cheapest(hull_cuts_);
  Cuts before;
  for (std::size_t round = 0; round < kMostRounds && before != cuts_; ++round) {
    before = cuts_;
    refute(asked_);
  }
}

/// Step 6. Evaluates batches until one has no counterexample, or none that opening could cure. Its samples are independent, since a rate is
/// concluded from them; for the same reason the last batch must not change the model, whatever it shows, and batches are counted: of many,
/// one is clear by chance.
void Fitting::verify() {
  next_ = std::max(next_, Assembly::kIndependentFrom);
  for (batches_ = 1; batches_ <= kMostRounds; ++batches_) {
    const Cuts hulls = hull_cuts_, all = cuts_;
    cureBatch(options_.samples);
    if (hulls == hull_cuts_ && all == cuts_) return;
  }
  if (!problem_.configurations.empty()) return;
  verified_from_ = next_;
  next_ += options_.samples;
}

void Fitting::run() {
  cureGrowingBatches();
  fitAll();
  verify();
  if (!options_.primitives) return;
  usePrimitives();
  verify();
}

}  // namespace collision_hulls
