// A host for a material: one or several ranks and blocks, the declared fields alone, the calls in Peridigm's order.
#ifndef PD_TESTS_MATERIAL_RUN_HPP
#define PD_TESTS_MATERIAL_RUN_HPP

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "Peridigm_Material.hpp"
#include "samples.hpp"

namespace pdtest {

/// Values by global id, of each field that a material yields.
using Results = std::map<std::string, std::vector<double>>;

/// Largest difference of two results over the largest value, over all fields.
double relativeDifference(const Results& a, const Results& b);

/// Current position of a point.
using Motion = std::function<Point(int globalId, const Point& reference)>;

/// A few per cent of strain and noise, in the dimensions of the sample.
Motion someMotion(int dimension);

struct Layout {
  int nRanks = 1;   ///< points are dealt out one by one
  int nBlocks = 1;  ///< points of even and odd columns
  bool isDamaged = false;
  BondSteps bondSteps = BondSteps::Shared;
  int salt = 0;  ///< not 0: points are dealt out at random
};

class MaterialRun {
 public:
  /// Creates and initialises one material a rank and block.
  MaterialRun(const Sample& sample, Layout layout);

  void initialize();
  void move(const Motion& motion);
  /// Precompute, synchronise, force, flux divergence, stored energy; summed over blocks and ranks.
  Results evaluate();

  SmallBody& body(std::size_t rank = 0) { return *bodies_[rank]; }
  const Scene& scene() const { return scene_; }
  PeridigmNS::Material& material() { return *materials_.front().front(); }
  /// Fields that the material adds to: forces and rates.
  std::vector<std::string> summedFields();
  /// Fields that the material and the host have put into the body.
  std::vector<int> fieldIds() const { return fieldIds_; }

 private:
  void fillInputs(SmallBody& body);
  void fillFlow(SmallBody& body);
  void damage();
  void synchronize(const std::vector<int>& fieldIds);
  void addSummed(Results& results, std::size_t rank, const std::string& label);

  Sample sample_;
  Scene scene_;
  Layout layout_;
  std::vector<int> fieldIds_;
  std::vector<std::unique_ptr<SmallBody>> bodies_;
  std::vector<std::vector<Teuchos::RCP<PeridigmNS::Material>>> materials_;  ///< [rank][block]
};

/// Copies the values of owners (by global id) to ghosts.
void copyToGhosts(const std::vector<std::unique_ptr<SmallBody>>& bodies, const std::string& label);

/// A body of a rank of the layout, without fields.
std::unique_ptr<SmallBody> bareBody(const Scene& scene, const Layout& layout, int rank);

}  // namespace pdtest

#endif
