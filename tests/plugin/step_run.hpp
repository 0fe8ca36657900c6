// A host that takes steps with a plug-in of either kind and looks at every field that it declares.
#ifndef PD_TESTS_STEP_RUN_HPP
#define PD_TESTS_STEP_RUN_HPP

#include <memory>
#include <optional>

#include "Peridigm_DamageModel.hpp"
#include "fields.hpp"
#include "material_run.hpp"

namespace pdtest {

/// Every declared field: of points by global id, of bonds by the global ids of their ends.
struct FieldState {
  std::map<std::string, std::vector<double>> points;
  std::map<std::string, std::map<std::pair<int, int>, double>> bonds;
};

/// Where two states differ by more than `tolerance` of the largest value of the field; empty where they do not.
std::string differenceOf(const FieldState& a, const FieldState& b, double tolerance);

enum class PluginKind { Material, DamageModel };

class StepRun {
 public:
  /// Creates and initialises the plug-in for each rank and block.
  StepRun(const Sample& sample, PluginKind kind, Layout layout);

  /// Sets what the plug-in reads as a growing load makes it: coordinates, and scalars that step.
  void load(double load);
  /// All calls of a step that change fields, in the order of hosts, `dt` = 0.1 s.
  void evaluate();
  /// NP1 becomes N, and the plug-in is told.
  void accept();
  void step(double load);
  /// Remembers what a host remembers (stepped fields, one-step fields that are state), and brings it back.
  void begin();
  void takeBack();
  /// Throws the plug-ins away and makes new ones, as a host may between steps.
  void recreate();
  /// A new run on the fields of another one at the end of a step, as from a checkpoint.
  void goOnFrom(const FieldState& state);
  FieldState state();

  // Of the first rank and block.
  SmallBody& body() { return *bodies_.front(); }
  std::vector<int> fieldIds();
  std::vector<int> synchronised(pd::Ghosts when);
  /// Throws std::invalid_argument where the plug-in has none.
  const pd::FieldTable& table();

 private:
  template <class Work>
  void forEachBlock(const Work& work);
  bool isSummed(int fieldId);  ///< the plug-in adds to it: each block has its own, and the host sums them
  std::vector<int> keptFieldIds();
  void copyDeclared(const std::vector<int>& fieldIds);
  void initialize();

  Sample sample_;
  PluginKind kind_;
  Scene scene_;
  Layout layout_;
  double time_ = 0.0;
  bool hasEvaluated_ = false;  ///< since the last accepted step
  std::vector<std::unique_ptr<SmallBody>> bodies_;
  std::vector<std::vector<Teuchos::RCP<PeridigmNS::Material>>> materials_;        ///< [rank][block]
  std::vector<std::vector<Teuchos::RCP<PeridigmNS::DamageModel>>> damageModels_;  ///< [rank][block]
  std::vector<std::vector<double>> saved_;
};

/// What a plug-in breaks of the contract of steps, a line each; empty: nothing.
std::string brokenStepContract(const Sample& sample, PluginKind kind);

}  // namespace pdtest

#endif
