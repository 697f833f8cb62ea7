// Refinement by counterexample: finds the cuts that a scene needs.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "fit/curing.h"
#include "fit/originals.h"
#include "fit/pair_rules.h"

namespace collision_hulls {

/// What samples reveal about a model.
struct Answers {
  std::vector<Contact> current;      ///< contacts of the model in counterexamples
  std::vector<Contact> roots;        ///< contacts of the trees' roots in the same samples
  std::vector<std::size_t> samples;  ///< these samples
  std::vector<Contact> leaves;       ///< one contact per counterexample that not even the finest hulls cure
};

class Fitting {
 public:
  Fitting(const FitProblem& problem, const FitOptions& options, const Assembly& assembly, const Originals& originals,
          const PairRules& rules, const RunControl& control)
      : problem_(problem),
        options_(options),
        assembly_(assembly),
        originals_(originals),
        rules_(rules),
        pairs_(assembly, rules.pairs),
        control_(control),
        hull_cuts_(assembly.roots()) {}

  void run();

  const Cuts& cuts() const { return options_.primitives ? cuts_ : hull_cuts_; }
  const Cuts& hullCuts() const { return hull_cuts_; }          ///< with hulls in place of primitives
  const CheckedPairs& pairs() const { return pairs_; }         ///< to check, by the rules
  std::size_t verifiedFrom() const { return verified_from_; }  ///< first sample of the last batch, on which the model does not depend
  std::size_t verifyingBatches() const { return batches_; }    ///< up to that one, each of which might have been the last
  std::size_t asked() const { return asked_.size(); }
  std::size_t cured() const { return cured_; }
  const std::vector<Contact>& leafContacts() const { return leaves_; }  ///< left over in the last batch
  const std::vector<Contact>& seen() const { return seen_; }            ///< of roots and of opened hulls, in all counterexamples

 private:
  bool touch(const std::set<PartIndices>& parts, const Places& places) const;
  Answers ask(const std::vector<std::size_t>& samples) const;
  std::size_t cure(const std::vector<std::size_t>& samples);
  void takeHulls(const Cuts& cuts);
  std::size_t refute(const std::vector<std::size_t>& samples);
  std::size_t cureBatch(std::size_t count);
  void cureGrowingBatches();
  void fitAll();
  void usePrimitives();
  void verify();

  const FitProblem& problem_;
  const FitOptions& options_;
  const Assembly& assembly_;
  const Originals& originals_;
  const PairRules& rules_;
  const CheckedPairs pairs_;  // of the rules
  const RunControl& control_;
  Cuts hull_cuts_, cuts_;  // the latter with primitives, once there are any
  std::vector<Contact> roots_, seen_, leaves_;
  std::vector<std::size_t> asked_;  // samples
  std::size_t next_ = 0, cured_ = 0, verified_from_ = 0, batches_ = 0;
  double progress_ = 0;
};

/// Whether the original keeps its clearances. Urgent pairs are checked first, which only saves time.
bool isClear(const Originals& originals, const CheckedPairs& pairs, const Places& places);

}  // namespace collision_hulls
