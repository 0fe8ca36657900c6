// Directed bond-updates per second of the plug-ins' evaluations on one core, on lattices and on a jittered mesh.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>

#include "Peridigm_Block.hpp"
#include "Peridigm_InfluenceFunction.hpp"
#include "plugins.hpp"

namespace {

using namespace PeridigmNS;
using namespace PeridigmNS::PeridigmField;

/// A lattice with its plug-ins; spacing 1 mm, horizon in spacings, neighbours up to horizon + half a spacing.
class Body {
 public:
  Body(std::array<int, 3> n, double horizon, double jitter, Teuchos::ParameterList material,
       Teuchos::ParameterList damage)
      : isPlane_(n[2] == 1) {
    material.set("Horizon", horizon * spacing);
    material_ = pd::MaterialRegistry::self().create("PDHE", material);
    damage_ = pd::DamageModelRegistry::self().create(damage.get<std::string>("Damage Model"), damage);
    makeLists(n, horizon + 0.5);
    const int count = n[0] * n[1] * n[2];
    std::vector<int> globalIds(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) globalIds[static_cast<std::size_t>(i)] = i;
    const auto map = Teuchos::rcp(new PointMap(globalIds));
    data_.setMaps(map, map, static_cast<int>(list_.size()) - count);
    data_.shareSteps({pd::fields::bondDamage().id()});  // as pdrun does where all say that it only grows
    data_.allocateData(material_->FieldIds());
    data_.allocateData(damage_->FieldIds());
    data_.allocateData({FieldManager::self().getFieldId(NODE, SCALAR, TWO_STEP, "Concentration")});
    fill(n, jitter);
    damage_->initialize(0.0, count, owned_.data(), list_.data(), data_);
    material_->initialize(0.0, count, owned_.data(), list_.data(), data_);
  }
  double nBonds() const { return static_cast<double>(list_.size() - owned_.size()); }
  void diffuse() { material_->computeFluxDivergence(0.0, int(owned_.size()), owned_.data(), list_.data(), data_); }
  void damage() { damage_->computeDamage(0.0, int(owned_.size()), owned_.data(), list_.data(), data_); }
  void force() { material_->computeForce(0.0, int(owned_.size()), owned_.data(), list_.data(), data_); }

 private:
  static constexpr double spacing = 1e-3;

  void makeLists(std::array<int, 3> n, double reach) {
    const int r = static_cast<int>(reach);
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i) {
          owned_.push_back(static_cast<int>(owned_.size()));
          const std::size_t head = list_.size();
          list_.push_back(0);
          for (int c = std::max(0, k - r); c <= std::min(n[2] - 1, k + r); ++c)
            for (int b = std::max(0, j - r); b <= std::min(n[1] - 1, j + r); ++b)
              for (int a = std::max(0, i - r); a <= std::min(n[0] - 1, i + r); ++a) {
                const double distance = std::hypot(a - i, b - j, c - k);
                if (distance > 0.0 && distance < reach) list_.push_back((c * n[1] + b) * n[0] + a);
              }
          list_[head] = static_cast<int>(list_.size() - head) - 1;
        }
  }
  void fill(std::array<int, 3> n, double jitter) {
    auto& fields = FieldManager::self();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    double *x = nullptr, *y = nullptr, *volume = nullptr, *concentration = nullptr;
    data_.getData(fields.getFieldId("Model_Coordinates"), STEP_NONE)->ExtractView(&x);
    data_.getData(fields.getFieldId("Coordinates"), STEP_NP1)->ExtractView(&y);
    data_.getData(fields.getFieldId("Volume"), STEP_NONE)->ExtractView(&volume);
    data_.getData(fields.getFieldId("Concentration"), STEP_NP1)->ExtractView(&concentration);
    for (int i = 0; i < int(owned_.size()); ++i) {
      const int at[3] = {i % n[0], i / n[0] % n[1], i / (n[0] * n[1])};
      for (int d = 0; d < 3; ++d) {
        const bool isMoving = d < 2 || !isPlane_;
        x[3 * i + d] = spacing * (at[d] + (isMoving ? jitter * unit(random) : 0.0));
        y[3 * i + d] = x[3 * i + d] + (isMoving ? 1e-4 * spacing * unit(random) : 0.0);
      }
      volume[i] = spacing * spacing * spacing;
      concentration[i] = unit(random);
    }
  }

  bool isPlane_;
  Teuchos::RCP<Material> material_;
  Teuchos::RCP<DamageModel> damage_;
  DataManager data_;
  std::vector<int> owned_, list_;
};

std::unique_ptr<Body> makeBody(bool isPlane, double jitter, double poissonsRatio, bool isLarge) {
  Teuchos::ParameterList material, damage;
  material.set("Young's Modulus", 207.0e9);
  material.set("Poisson's Ratio", poissonsRatio);
  material.set("Diffusivity", 1e-9);
  material.set("Plane Stress", isPlane);
  material.set("Thickness", 1e-3);
  damage.set("Damage Model", "Hydrogen Critical Stretch");
  damage.set("Critical Stretch", 0.01);
  damage.set("Saturation Concentration", 1.0);
  // The plate of the seed (about 12 k points of 45 bonds), or a body that no cache holds.
  if (isPlane)
    return std::make_unique<Body>(isLarge ? std::array<int, 3>{1000, 500, 1} : std::array<int, 3>{155, 77, 1}, 3.6,
                                  jitter, material, damage);
  const int n = isLarge ? 80 : 46;
  return std::make_unique<Body>(std::array<int, 3>{n, n, n}, 3.015, jitter, material, damage);
}

/// Arguments: plane, jitter in percent of the spacing, Poisson's ratio in percent, large. The body is kept from one
/// call to the next: the library calls several times, with more iterations each, and to make a large body takes
/// seconds.
Body& bodyOf(const benchmark::State& state) {
  static std::unique_ptr<Body> body;
  static std::array<std::int64_t, 4> made{};
  const std::array<std::int64_t, 4> asked = {state.range(0), state.range(1), state.range(2), state.range(3)};
  if (!body || asked != made) {
    body.reset();
    body = makeBody(asked[0] != 0, 0.01 * double(asked[1]), 0.01 * double(asked[2]), asked[3] != 0);
    made = asked;
  }
  return *body;
}

template <class Work>
void run(benchmark::State& state, Work work) {
  Body& body = bodyOf(state);
  work(body);
  for (auto _ : state) work(body);
  state.counters["bond_updates_per_s"] =
      benchmark::Counter(body.nBonds(), benchmark::Counter::kIsIterationInvariantRate);
}

void diffusion(benchmark::State& state) {
  run(state, [](Body& body) { body.diffuse(); });
}
void damageTest(benchmark::State& state) {
  run(state, [](Body& body) { body.damage(); });
}
void force(benchmark::State& state) {
  run(state, [](Body& body) { body.force(); });
}
void mechanicsBreaking(benchmark::State& state) {
  run(state, [](Body& body) {
    body.damage();
    body.force();
  });
}

void arguments(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"plane", "jitter", "nu", "large"})->Unit(benchmark::kMillisecond);
  for (const int plane : {1, 0})
    for (const int jitter : {0, 20})
      for (const int large : {0, 1}) bench->Args({plane, jitter, plane == 1 ? 29 : 20, large});
}
void mechanicsArguments(benchmark::internal::Benchmark* bench) {
  arguments(bench);
  bench->Args({1, 0, 33, 0})->Args({0, 0, 25, 0});
}

BENCHMARK(diffusion)->Apply(arguments);
BENCHMARK(damageTest)->Apply(arguments);
BENCHMARK(force)->Apply(mechanicsArguments);
BENCHMARK(mechanicsBreaking)->Apply(mechanicsArguments);

}  // namespace

BENCHMARK_MAIN();
