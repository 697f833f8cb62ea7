#include "scene/fitting.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>

namespace collision_hulls {
namespace {

constexpr std::size_t kFirstBatch = 256;  // samples; the next ones are twice as large each
constexpr int kMostRounds = 12;           // of verification

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

Answers Fitting::ask(const Cuts& cuts, std::size_t first, std::size_t count) const {
  std::vector<Answer> answers(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    control_.check();
    const Places places = assembly_.places(first + i);
    std::vector<Contact> current = contacts(assembly_, cuts, rules_.pairs, places, first + i);
    if (current.empty() || !isClear(assembly_, originals_, rules_.pairs, places, current)) return;
    Answer& answer = answers[i];
    answer.at_leaves = std::any_of(current.begin(), current.end(), [&](const Contact& c) { return touchesAtLeaves(assembly_, c); });
    answer.roots = contacts(assembly_, assembly_.tops(), rules_.pairs, places, first + i);
    answer.current = std::move(current);
  });
  Answers all;
  for (const Answer& answer : answers) {
    if (answer.current.empty()) continue;
    if (answer.at_leaves) {
      all.leaves.push_back(answer.current.front());
      continue;
    }
    ++all.counterexamples;
    all.current.insert(all.current.end(), answer.current.begin(), answer.current.end());
    all.roots.insert(all.roots.end(), answer.roots.begin(), answer.roots.end());
  }
  return all;
}

/// Asks fresh samples and cures what they show; the number of counterexamples.
std::size_t Fitting::cureBatch(std::size_t count) {
  verified_from_ = next_;
  const Answers answers = ask(cuts_, next_, count);
  if (problem_.configurations.empty()) next_ += count;
  asked_ += count;
  cured_ += answers.counterexamples;
  leaves_ = answers.leaves;
  roots_.insert(roots_.end(), answers.roots.begin(), answers.roots.end());
  if (answers.counterexamples > 0) {
    Curing curing(assembly_, cuts_);
    curing.add(answers.current);
    curing.run(control_);
    cuts_ = curing.cuts();
  }
  progress_ += (1 - progress_) / 8;
  control_.report(progress_);
  return answers.counterexamples;
}

/// 3. Batches that grow: the first ones find most, at little cost.
void Fitting::fitFirst() {
  const std::size_t given = problem_.configurations.size();
  if (given > 0) {
    cureBatch(given);
    return;
  }
  for (std::size_t count = kFirstBatch; count < options_.samples; count *= 2) cureBatch(count);
}

/// 4. With all counterexamples known, from the beginning; whichever is less.
void Fitting::fitAll() {
  Curing curing(assembly_, assembly_.tops());
  curing.add(roots_);
  curing.run(control_);
  const Cuts again = closed(assembly_, curing.cuts(), roots_, control_), mended = closed(assembly_, cuts_, roots_, control_);
  cuts_ = assembly_.hulls(again) <= assembly_.hulls(mended) ? again : mended;
}

/// 5. Until a batch has no counterexample. Its samples are independent, since a rate is concluded from them.
void Fitting::verify() {
  if (problem_.configurations.empty()) next_ = Assembly::kIndependentFrom;
  const std::size_t given = problem_.configurations.size();
  for (int round = 0; round < kMostRounds; ++round)
    if (cureBatch(given > 0 ? given : options_.samples) == 0) return;
}

void Fitting::run() {
  fitFirst();
  fitAll();
  verify();
}

}  // namespace collision_hulls
