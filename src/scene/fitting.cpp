#include "scene/fitting.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace collision_hulls {
namespace {

constexpr std::size_t kFirstBatch = 256;  // samples; the next ones are twice as large each
constexpr int kMostRounds = 12;           // over the same samples, and of verification

struct Answer {
  std::vector<Contact> current, roots;
  bool at_leaves = false;
};

}  // namespace

bool isClear(const Assembly& assembly, const Originals& originals, const std::vector<PartPair>& pairs, const Places& places,
             const std::vector<Contact>& suspects) {
  std::set<std::pair<std::size_t, std::size_t>> suspected;
  const auto part = [&](int piece) { return assembly.pieces()[static_cast<std::size_t>(piece)].part; };
  for (const Contact& contact : suspects) suspected.emplace(part(contact.piece[0]), part(contact.piece[1]));
  const auto is_clear = [&](bool suspect) {
    return std::all_of(pairs.begin(), pairs.end(), [&](const PartPair& pair) {
      return (suspected.count({pair.a, pair.b}) > 0) != suspect || originals.clear(pair, places);
    });
  };
  return is_clear(true) && is_clear(false);
}

Answers Fitting::ask(const std::vector<std::size_t>& samples) const {
  std::vector<Answer> answers(samples.size());
  tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t i) {
    control_.check();
    const Places places = assembly_.places(samples[i]);
    std::vector<Contact> current = contacts(assembly_, cuts_, pairs_, places, samples[i]);
    if (current.empty() || !isClear(assembly_, originals_, pairs_, places, current)) return;
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

/// Asks samples and cures what they show; the number of counterexamples.
std::size_t Fitting::cure(const std::vector<std::size_t>& samples) {
  const Answers answers = ask(samples);
  asked_ += samples.size();
  leaves_ = answers.leaves;
  known_.insert(known_.end(), answers.samples.begin(), answers.samples.end());
  roots_.insert(roots_.end(), answers.roots.begin(), answers.roots.end());
  seen_.insert(seen_.end(), answers.roots.begin(), answers.roots.end());
  seen_.insert(seen_.end(), answers.current.begin(), answers.current.end());
  if (!answers.samples.empty()) {
    Curing curing(assembly_, cuts_, with_primitives_);
    curing.add(answers.current);
    curing.run(control_);
    cuts_ = curing.cuts();
  }
  progress_ += (1 - progress_) / 8;
  control_.report(progress_);
  return answers.samples.size();
}

/// The same with the samples that come next; all of those that were given.
std::size_t Fitting::cureBatch(std::size_t count) {
  const std::size_t given = problem_.configurations.size();
  std::vector<std::size_t> samples(given > 0 ? given : count);
  std::iota(samples.begin(), samples.end(), given > 0 ? 0 : next_);
  verified_from_ = samples.front();
  next_ += samples.size();
  const std::size_t found = cure(samples);
  cured_ += found;
  return found;
}

/// The first ones find most, at little cost.
void Fitting::cureGrowingBatches() {
  if (!problem_.configurations.empty()) {
    cureBatch(problem_.configurations.size());
    return;
  }
  for (std::size_t count = kFirstBatch; count < options_.samples; count *= 2) cureBatch(count);
}

/// 4. With all counterexamples known, from the beginning; whichever is less.
void Fitting::fitAll() {
  Curing curing(assembly_, assembly_.roots());
  curing.add(roots_);
  curing.run(control_);
  const Cuts again = closed(assembly_, curing.cuts(), roots_, control_), mended = closed(assembly_, cuts_, roots_, control_);
  cuts_ = assembly_.hulls(again) <= assembly_.hulls(mended) ? again : mended;
}

/// 5. First where hulls were refuted: there primitives are most likely to be. A primitive that takes another one's place may touch where
/// that one did not, so the same samples are asked until they say nothing more.
void Fitting::usePrimitives() {
  with_primitives_ = true;
  cuts_ = assembly_.cheapest(cuts_);
  pairs_ = lookedAtAndProved(rules_, options_.clearance);
  const std::vector<std::size_t> refuted = known_;
  for (int round = 0; round < kMostRounds && cure(refuted) > 0; ++round) continue;
  cureGrowingBatches();
}

/// 6. Until a batch has no counterexample. Its samples are independent, since a rate is concluded from them.
void Fitting::verify() {
  next_ = Assembly::kIndependentFrom;
  for (int round = 0; round < kMostRounds; ++round)
    if (cureBatch(options_.samples) == 0) return;
}

void Fitting::run() {
  cureGrowingBatches();
  fitAll();
  hull_cuts_ = cuts_;
  if (options_.primitives) usePrimitives();
  verify();
}

}  // namespace collision_hulls
