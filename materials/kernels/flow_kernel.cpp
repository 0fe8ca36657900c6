#include "flow_kernel.hpp"

#include <limits>

namespace pd::kernels {

namespace {

/// Largest difference of weights, of the largest, that is taken for rounding of the points' places.
constexpr double sameWeight = 1e-11;

/// Values at the points of a chunk, and at the neighbours of entry k.
template <bool isContiguous>
struct ChunkValues {
  const Chunk& chunk;
  const int* indices;
  const int* points;

  PD_EACH_BOND Vector own(const double* values) const {
    return isContiguous ? load(values + chunk.firstPoint) : gather(values, points);
  }
  PD_EACH_BOND Vector at(const double* values, int k) const {
    return isContiguous ? load(values + chunk.firstPoint + indices[k]) : gather(values, indices + k * lanes);
  }
};

void storeAtPoints(const Chunk& chunk, const int* points, const Vector& vector, double* values) {
  if (chunk.isContiguous && chunk.nLanes == lanes)
    store(vector, values + chunk.firstPoint);
  else
    for (int lane = 0; lane < chunk.nLanes; ++lane) values[points[lane]] = vector[static_cast<std::size_t>(lane)];
}

/// Calls work(chunk, values, weight, mask) for each chunk. weight(i): weight i of the chunk's entries, entry by entry;
/// mask(difference, k): the difference where lanes have entry k.
template <class Work>
void forEachChunk(const FlowStencils& stencils, const Work& work) {
  const ChunkedNeighborhood& neighborhood = stencils.neighborhood();
  const std::vector<Chunk>& chunks = neighborhood.chunks();
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    const Chunk& chunk = chunks[c];
    const double* weights = stencils.weights().of(c);
    const unsigned char* present = neighborhood.present(chunk);
    const int* points = neighborhood.pointIds(chunk);
    const auto broadcast = [weights](int i) PD_INLINED { return Vector(weights[i]); };
    // Zero in lanes that have no such neighbour.
    const auto ofLanes = [weights](int i) PD_INLINED { return load(weights + i * lanes); };
    const auto all = [](const Vector& difference, int) PD_INLINED { return difference; };
    const auto some = [present](const Vector& difference, int k) PD_INLINED { return keep(difference, present[k]); };
    if (!chunk.isContiguous)
      work(chunk, ChunkValues<false>{chunk, neighborhood.neighborIds(chunk), points}, ofLanes, all);
    else if (const ChunkValues<true> values{chunk, neighborhood.offsets(chunk), points};
             !stencils.weights().isUniform(c))
      work(chunk, values, ofLanes, all);
    else if (chunk.isFull)
      work(chunk, values, broadcast, all);
    else
      work(chunk, values, broadcast, some);
  }
}

template <int D, bool isScalar>
void flowViscosity(const FlowStencils& stencils, const FlowState& state, FlowOperators& result) {
  constexpr int width = isScalar ? 1 : D * D;
  forEachChunk(stencils, [&](const Chunk& chunk, const auto& values, const auto& weight, const auto& mask) {
    Vector own[D], sum[D];
    unrolled<D>([&](auto a) PD_INLINED {
      own[a] = values.own(state.velocity[a]);
      sum[a] = 0.0;
    });
    for (int k = 0; k < chunk.nNeighbors; ++k) {
      Vector difference[D];
      unrolled<D>([&](auto a) PD_INLINED { difference[a] = mask(values.at(state.velocity[a], k) - own[a], k); });
      if constexpr (isScalar) {
        const Vector w = weight(k);
        unrolled<D>([&](auto a) PD_INLINED { sum[a] += w * difference[a]; });
      } else {
        unrolled<D>([&](auto a) PD_INLINED {
          unrolled<D>([&](auto b) PD_INLINED { sum[a] += weight(width * k + D * a + b) * difference[b]; });
        });
      }
    }
    unrolled<D>([&](auto a) PD_INLINED { storeAtPoints(chunk, values.points, sum[a], result.viscous[a]); });
  });
}

template <int D, bool isScalar>
void flowGradients(const FlowStencils& stencils, const FlowState& state, FlowOperators& result) {
  constexpr int ofVelocity = isScalar ? D : D * D, width = ofVelocity + D;
  forEachChunk(stencils, [&](const Chunk& chunk, const auto& values, const auto& weight, const auto& mask) {
    Vector own[D], gradient[D * D], ofPressure[D];
    const Vector ownPressure = values.own(state.pressure[0]);
    unrolled<D>([&](auto a) PD_INLINED {
      own[a] = values.own(state.velocity[a]);
      ofPressure[a] = 0.0;
      unrolled<D>([&](auto b) PD_INLINED { gradient[D * a + b] = 0.0; });
    });
    for (int k = 0; k < chunk.nNeighbors; ++k) {
      const Vector pressure = mask(values.at(state.pressure[0], k) - ownPressure, k);
      unrolled<D>([&](auto b) PD_INLINED { ofPressure[b] += weight(width * k + ofVelocity + b) * pressure; });
      unrolled<D>([&](auto a) PD_INLINED {
        const Vector difference = mask(values.at(state.velocity[a], k) - own[a], k);
        unrolled<D>([&](auto b) PD_INLINED {
          gradient[D * a + b] += weight(width * k + (isScalar ? b : D * a + b)) * difference;
        });
      });
    }
    Vector divergence = 0.0;
    unrolled<D>([&](auto a) PD_INLINED {
      Vector convection = 0.0;
      unrolled<D>([&](auto b) PD_INLINED { convection += own[b] * gradient[D * a + b]; });
      storeAtPoints(chunk, values.points, convection, result.convection[a]);
      storeAtPoints(chunk, values.points, ofPressure[a], result.pressureGradient[a]);
      divergence += gradient[D * a + a];
    });
    storeAtPoints(chunk, values.points, divergence, result.divergence[0]);
  });
}

/// x^n, n >= 0.
template <class Number>
PD_EACH_BOND Number wholePower(Number x, int n) {
  Number result = 1.0;
  for (; n > 0; n /= 2, x = x * x)
    if (n % 2 == 1) result = result * x;
  return result;
}

/// r with r^n = 1 + x, by three of Newton's steps from the series up to x^2: 1e-14 at |x| = 1/2, rounding below 0.1.
template <class Number>
PD_EACH_BOND Number wholeRoot(const Number& x, int n) {
  const double inverse = 1.0 / n;
  Number r = 1.0 + x * inverse * (1.0 + 0.5 * (inverse - 1.0) * x);
  for (int step = 0; step < 3; ++step) {
    const Number power = wholePower(r, n - 1);
    r = r - inverse * (r - (1.0 + x) / power);
  }
  return r;
}

template <int D>
void flowRatesOf(const TaitFluid& fluid, int nPoints, const FlowState& state, const FlowOperators& operators,
                 const PointArrays& force, const PointArrays& tau, FlowState& result, PointArrays& density) {
  const double reference = fluid.density * fluid.soundSpeed * fluid.soundSpeed,
               perReference = fluid.exponent / reference;
  for (int i = 0; i < nPoints; i += lanes) {
    const Vector pressure = load(state.pressure[0] + i);
    const Vector bulkModulus = reference + fluid.exponent * pressure;
    const Vector ownDensity = fluid.density * wholeRoot(Vector(perReference * pressure), fluid.exponent);
    const Vector perDensity = 1.0 / ownDensity;
    store(ownDensity, density[0] + i);
    Vector change =
        bulkModulus * (load(tau[0] + i) * load(operators.smoothing[0] + i) - load(operators.divergence[0] + i));
    unrolled<D>([&](auto a) PD_INLINED {
      const Vector gradient = load(operators.pressureGradient[a] + i);
      const Vector stress = fluid.viscosity * load(operators.viscous[a] + i) - gradient + load(force[a] + i);
      store(stress * perDensity - load(operators.convection[a] + i), result.velocity[a] + i);
      change -= load(state.velocity[a] + i) * gradient;
    });
    store(change, result.pressure[0] + i);
  }
}

}  // namespace

FlowStencils::FlowStencils(std::vector<int> points, std::vector<int> list, const std::vector<double>& weights,
                           int width)
    : points_(std::move(points)),
      list_(std::move(list)),
      neighborhood_(static_cast<int>(points_.size()), points_.data(), list_.data()),
      weights_(
          neighborhood_, width,
          [&](int, int, std::size_t bond, double* values) {
            const auto first = static_cast<std::ptrdiff_t>(bond) * width;
            std::copy_n(weights.begin() + first, width, values);
          },
          BondConstants::Keep::All, sameWeight) {}

double FlowStencils::uniformShare() const {
  double uniform = 0.0, all = 0.0;
  const std::vector<Chunk>& chunks = neighborhood_.chunks();
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    const double bonds = chunks[c].nNeighbors * chunks[c].nLanes;
    all += bonds;
    if (weights_.isUniform(c)) uniform += bonds;
  }
  return all > 0.0 ? uniform / all : 0.0;
}

void applyViscosity(const FlowStencils& stencils, FlowWeights kind, int dimension, const FlowState& state,
                    FlowOperators& result) {
  withDimension(dimension, [&](auto d) {
    if (kind == FlowWeights::Scalar)
      flowViscosity<d, true>(stencils, state, result);
    else
      flowViscosity<d, false>(stencils, state, result);
  });
}

void applyGradients(const FlowStencils& stencils, FlowWeights kind, int dimension, const FlowState& state,
                    FlowOperators& result) {
  withDimension(dimension, [&](auto d) {
    if (kind == FlowWeights::Scalar)
      flowGradients<d, true>(stencils, state, result);
    else
      flowGradients<d, false>(stencils, state, result);
  });
}

double TaitFluid::densityAt(double pressure) const {
  const double x = exponent * pressure / (density * soundSpeed * soundSpeed);
  return x > -1.0 ? density * wholeRoot(x, exponent) : std::numeric_limits<double>::quiet_NaN();
}

void flowRates(const TaitFluid& fluid, int dimension, int nPoints, const FlowState& state,
               const FlowOperators& operators, const PointArrays& force, const PointArrays& tau, FlowState& result,
               PointArrays& density) {
  withDimension(dimension,
                [&](auto d) { flowRatesOf<d>(fluid, nPoints, state, operators, force, tau, result, density); });
}

void advanceFlow(int dimension, int nPoints, const FlowState& base, double factor, const FlowState& rates,
                 FlowState& result) {
  const auto advance = [&](const double* from, const double* rate, double* to) {
    for (int i = 0; i < nPoints; ++i) to[i] = from[i] + factor * rate[i];
  };
  for (int a = 0; a < dimension; ++a) advance(base.velocity[a], rates.velocity[a], result.velocity[a]);
  advance(base.pressure[0], rates.pressure[0], result.pressure[0]);
}

}  // namespace pd::kernels
