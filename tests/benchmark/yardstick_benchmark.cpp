// Rates of the bare loops, each by its name in benchmark.json. quick: of tiny bodies.
#include <benchmark/benchmark.h>

#include "yardstick.hpp"

namespace {

using pd_benchmark::BareBody;

/// Kept from one call to the next, as to make it takes longer than to measure it.
BareBody& bodyOf(const benchmark::State& state) {
  static BareBody whole(46), tiny(12);  // whole: 11 M bonds, the block of the whole runs
  return state.range(0) != 0 ? tiny : whole;
}

void reportBonds(benchmark::State& state, const BareBody& body) {
  state.counters["rate"] = benchmark::Counter(body.nBonds(), benchmark::Counter::kIsIterationInvariantRate);
}

void yardstick_list_bond_updates_per_s(benchmark::State& state) {
  BareBody& body = bodyOf(state);
  for (auto _ : state) {
    body.forceByList();
    benchmark::ClobberMemory();
  }
  reportBonds(state, body);
}

void yardstick_lattice_bond_updates_per_s(benchmark::State& state) {
  BareBody& body = bodyOf(state);
  for (auto _ : state) {
    body.forceByOffsets();
    benchmark::ClobberMemory();
  }
  reportBonds(state, body);
}

/// Bytes of each of the three arrays: as many as the largest cache holds, so that together they never fit.
std::size_t arrayBytes() {
  std::size_t bytes = std::size_t(64) << 20;
  for (const auto& cache : benchmark::CPUInfo::Get().caches)
    bytes = std::max(bytes, static_cast<std::size_t>(cache.size));
  return bytes;
}

void yardstick_triad_bytes_per_s(benchmark::State& state) {
  const std::size_t n = (state.range(0) != 0 ? std::size_t(1) << 20 : arrayBytes()) / sizeof(double);
  std::vector<double> a(n, 0.0);
  const std::vector<double> b(n, 1.0), c(n, 2.0);
  for (auto _ : state) {
    pd_benchmark::triad(a, b, c);
    benchmark::ClobberMemory();
  }
  state.counters["rate"] =
      benchmark::Counter(24.0 * static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate);
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->ArgName("quick")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
}

BENCHMARK(yardstick_list_bond_updates_per_s)->Apply(sizes);
BENCHMARK(yardstick_lattice_bond_updates_per_s)->Apply(sizes);
BENCHMARK(yardstick_triad_bytes_per_s)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
