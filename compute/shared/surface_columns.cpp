#include "surface_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pd {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Two unit vectors at right angles to a unit vector and each other; along axes of coordinates where it is.
std::array<Vector3, 2> axesAcross(const Vector3& direction) {
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(direction[k]) < std::abs(direction[least])) least = k;
  Vector3 first{};
  first[least] = 1.0;
  double length = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    first[k] -= direction[least] * direction[k];
    length += first[k] * first[k];
  }
  for (double& component : first) component /= std::sqrt(length);
  return {first, cross(direction, first)};
}

}  // namespace

void SurfaceColumns::declareParameters(ParameterDeclarations& declarations) {
  declarations.text("Node Set", "Points at the original surface; what lies behind them is looked at.").required();
  declareVector(declarations, "Into", "1", "Direction from the surface into the metal (default: x; any length).");
  declarations
      .real(
          "Column Width", "m",
          "Width of the columns into which the surface is divided; by default each point of the node set has its own, "
          "which those in line with it share. For meshes without rows: one to three spacings.")
      .positive();
  declarations
      .text("Measure",
            "Dissolved: metal that is gone, counted down the column. Deepest: how far below the node set liquid "
            "reaches, whether that was metal or not, under overhangs too, and from there on what is gone.")
      .oneOf({"Dissolved", "Deepest"})
      .defaultTo("Dissolved");
  DissolvedMetal::declareParameters(declarations);
}

SurfaceColumns::SurfaceColumns(const Teuchos::ParameterList& parameters, const ComputeParameters& globalData)
    : nodeSet_(parameters.get<std::string>("Node Set")),
      points_(parameters, globalData),
      metal_(parameters),
      into_(directionOf(parameters, "Into")),
      hasDirection_(isVectorGiven(parameters, "Into")),
      axes_(axesAcross(into_)),
      width_(parameters.isParameter("Column Width") ? parameters.get<double>("Column Width") : 0.0),
      isDeepest_(parameters.get<std::string>("Measure") == "Deepest"),
      fields_(parameters) {}

void SurfaceColumns::initialize(const Blocks& blocks, const Epetra_Comm& comm) {
  points_.initialize(blocks);
  metal_.initialize(blocks);
  columns_.clear();
  findColumns(blocks, comm);
  findMembers(blocks, comm);
}

SurfaceColumns::Box SurfaceColumns::boxAround(const PointSelection& selection, const Blocks& blocks,
                                              const Epetra_Comm& comm) const {
  Box box{std::vector<double>(3, infinity), std::vector<double>(3, -infinity)};
  selection.forEach(blocks, [&](std::size_t b, int id) {
    const double* x = view((*blocks)[b], fields_.modelCoordinates) + 3 * id;
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], x[k]);
      box.high[k] = std::max(box.high[k], x[k]);
    }
  });
  return {minOverRanks(comm, box.low), maxOverRanks(comm, box.high)};
}

/// A surface that runs along x as the body does, and not across it, is not one into which x leads: the default would
/// make a few long columns of it, in silence.
void SurfaceColumns::requireDirection(const Box& body, const Box& surface) const {
  const bool runsAlong = surface.length(0) > 0.5 * body.length(0);
  const bool isThin = surface.length(1) < 0.5 * body.length(1) || surface.length(2) < 0.5 * body.length(2);
  if (runsAlong && isThin)
    throw std::invalid_argument("node set \"" + nodeSet_ +
                                "\" runs along x, the direction into the metal where none is given; give \"Into X\", "
                                "\"Into Y\" or \"Into Z\"");
}

/// From the points of the node set on all ranks.
void SurfaceColumns::findColumns(const Blocks& blocks, const Epetra_Comm& comm) {
  std::vector<double> coordinates;
  points_.forEach(blocks, [&](std::size_t b, int id) {
    const Place2 across = acrossOf(view((*blocks)[b], fields_.modelCoordinates) + 3 * id);
    coordinates.insert(coordinates.end(), across.begin(), across.end());
  });
  const Box body = boxAround(PointSelection(), blocks, comm);
  // Coordinates of meshes have six digits or more.
  for (std::size_t k = 0; k < 3; ++k) tolerance_ = std::max(tolerance_, 1e-6 * body.length(k));
  coordinates = gatherFromRanks(comm, coordinates);
  if (coordinates.empty()) throw std::invalid_argument("node set \"" + nodeSet_ + "\" has no points");
  if (!hasDirection_) requireDirection(body, boxAround(points_, blocks, comm));
  std::vector<Place2> places;
  for (std::size_t i = 0; i < coordinates.size(); i += 2) places.push_back({coordinates[i], coordinates[i + 1]});
  layout_ = width_ > 0.0 ? ColumnLayout::bins(places, width_) : ColumnLayout(places, tolerance_);
}

void SurfaceColumns::findMembers(const Blocks& blocks, const Epetra_Comm& comm) {
  surface_.clear();
  members_.clear();
  const auto memberOf = [&](std::size_t b, int id) {
    const double* x = view((*blocks)[b], fields_.modelCoordinates) + 3 * id;
    return Member{b, id, static_cast<std::size_t>(layout_.columnOf(acrossOf(x))), dot(into_, x)};
  };
  std::vector<double> start(static_cast<std::size_t>(layout_.count()), infinity);
  points_.forEach(blocks, [&](std::size_t b, int id) {
    surface_.push_back(memberOf(b, id));
    double& least = start[surface_.back().column];
    least = std::min(least, surface_.back().along);
  });
  start = minOverRanks(comm, start);
  PointSelection().forEach(blocks, [&](std::size_t b, int id) {
    const Member member = memberOf(b, id);
    if (member.column < start.size() && member.along >= start[member.column] - tolerance_) members_.push_back(member);
  });
}

struct SurfaceColumns::Layer {
  std::size_t column;
  double along, volume;
  double begin = 0.0, end = 0.0;
  double length() const { return end - begin; }
  bool operator<(const Layer& other) const {
    return column != other.column ? column < other.column : along < other.along;
  }
};

std::vector<DissolvedMetal::View> SurfaceColumns::metalOf(const Blocks& blocks) const {
  std::vector<DissolvedMetal::View> metal;
  for (PeridigmNS::Block& block : *blocks) metal.push_back(metal_.of(block));
  return metal;
}

/// Of all columns and ranks, in the order of columns and then along them.
std::vector<SurfaceColumns::Layer> SurfaceColumns::findLayers(const Blocks& blocks, const Epetra_Comm& comm) const {
  const std::vector<DissolvedMetal::View> metal = metalOf(blocks);
  std::vector<double> points;
  for (const Member& member : members_)
    points.insert(points.end(),
                  {static_cast<double>(member.column), member.along, metal[member.block].volume(member.id)});
  points = gatherFromRanks(comm, points);
  std::vector<Layer> single;
  for (std::size_t i = 0; i < points.size(); i += 3)
    single.push_back({static_cast<std::size_t>(points[i]), points[i + 1], points[i + 2]});
  std::sort(single.begin(), single.end());
  std::vector<Layer> layers;
  for (const Layer& point : single) {
    if (layers.empty() || layers.back().column != point.column || point.along > layers.back().along + tolerance_)
      layers.push_back(point);
    else
      layers.back().volume += point.volume;
  }
  return layers;
}

/// Where layers begin and end, and what columns they make.
void SurfaceColumns::fitColumns(std::vector<Layer>& layers) const {
  columns_.assign(static_cast<std::size_t>(layout_.count()), Column{});
  for (std::size_t c = 0; c < columns_.size(); ++c) columns_[c].across = layout_.place(static_cast<int>(c));
  double area = 0.0;
  int nMany = 0;
  for (std::size_t begin = 0, end = 0; begin < layers.size(); begin = end) {
    double volume = 0.0;
    for (; end < layers.size() && layers[end].column == layers[begin].column; ++end) {
      volume += layers[end].volume;
      if (end == begin) continue;
      Layer &before = layers[end - 1], &layer = layers[end];
      layer.begin = before.end =
          before.along + (layer.along - before.along) * before.volume / (before.volume + layer.volume);
    }
    if (end == begin + 1) continue;
    // A layer at an end of the column reaches as far outwards as inwards.
    Layer &first = layers[begin], &last = layers[end - 1];
    first.begin = 2.0 * first.along - first.end;
    last.end = 2.0 * last.along - last.begin;
    Column& column = columns_[first.column];
    column.firstLength = first.length();
    column.area = volume / (last.end - first.begin);
    area += column.area;
    ++nMany;
  }
  for (Layer& layer : layers) {
    if (layer.length() > 0.0 || nMany == 0) continue;
    // A lone point has no length of its own.
    Column& column = columns_[layer.column];
    column.area = area / nMany;
    column.firstLength = layer.volume / column.area;
    layer.begin = layer.along - 0.5 * column.firstLength;
    layer.end = layer.along + 0.5 * column.firstLength;
  }
}

/// Depth counts from the first metal on, or from the start of the column. Columns without metal are left out.
void SurfaceColumns::setTops(const Blocks& blocks, const Epetra_Comm& comm) const {
  const std::vector<DissolvedMetal::View> metal = metalOf(blocks);
  const std::size_t n = columns_.size();
  std::vector<double> least(2 * n, infinity);  // where columns begin, and where their metal does
  for (const Member& member : members_) {
    least[member.column] = std::min(least[member.column], member.begin);
    double& ofMetal = least[n + member.column];
    if (metal[member.block].wasMetal(member.id)) ofMetal = std::min(ofMetal, member.begin);
  }
  least = minOverRanks(comm, least);
  firstMetal_.assign(least.begin() + static_cast<std::ptrdiff_t>(n), least.end());
  bool hasMetal = false;
  for (std::size_t c = 0; c < n; ++c) {
    columns_[c].top = isDeepest_ ? least[c] : firstMetal_[c];
    if (firstMetal_[c] == infinity) columns_[c].area = 0.0;
    hasMetal = hasMetal || columns_[c].isMetal();
  }
  if (!hasMetal)
    throw std::runtime_error("no metal lies behind node set \"" + nodeSet_ +
                             "\": check \"Into\", and where the initial "
                             "concentration is that of the solid");
}

void SurfaceColumns::findMetal(const Blocks& blocks, const Epetra_Comm& comm) const {
  std::vector<Layer> layers = findLayers(blocks, comm);
  fitColumns(layers);
  if (layers.front().length() == 0.0)
    throw std::runtime_error("behind node set \"" + nodeSet_ +
                             "\" no two points stand in a row: check \"Into\", or give "
                             "\"Column Width\", one to three spacings");
  const std::vector<DissolvedMetal::View> metal = metalOf(blocks);
  for (Member& member : members_) {
    const auto next =
        std::upper_bound(layers.begin(), layers.end(), Layer{member.column, member.along + tolerance_, 0.0});
    const Layer& layer = *(next - 1);
    member.length = layer.length() * metal[member.block].volume(member.id) / layer.volume;
    member.begin = layer.begin;
    member.end = layer.end;
  }
  setTops(blocks, comm);
}

/// Length of metal that is gone, of points whose coordinate along the direction is more than `level` of their column.
std::vector<double> SurfaceColumns::dissolvedBelow(const Blocks& blocks, const Epetra_Comm& comm,
                                                   const std::vector<double>& level) const {
  const std::vector<DissolvedMetal::View> metal = metalOf(blocks);
  std::vector<double> length(columns_.size(), 0.0);
  for (const Member& member : members_)
    if (member.along > level[member.column])
      length[member.column] += metal[member.block].share(member.id) * member.length;
  return sumOverRanks(comm, length);
}

/// Coordinate along the direction where the deepest layer with a point that has dissolved ends; where the metal began
/// if there is none.
std::vector<double> SurfaceColumns::deepestLiquid(const Blocks& blocks, const Epetra_Comm& comm) const {
  const std::vector<DissolvedMetal::View> metal = metalOf(blocks);
  std::vector<double> deepest = firstMetal_;
  for (const Member& member : members_)
    if (metal[member.block].isGone(member.id)) deepest[member.column] = std::max(deepest[member.column], member.end);
  return maxOverRanks(comm, deepest);
}

SurfaceColumns::Profile SurfaceColumns::profile(const Blocks& blocks, const Epetra_Comm& comm) const {
  if (columns_.empty()) findMetal(blocks, comm);
  Profile result = columns_;
  std::vector<double> level(columns_.size(), -infinity);
  if (isDeepest_) level = deepestLiquid(blocks, comm);
  const std::vector<double> length = dissolvedBelow(blocks, comm, level);
  for (std::size_t c = 0; c < result.size(); ++c) {
    if (!result[c].isMetal()) continue;
    result[c].depth = length[c] + (isDeepest_ ? level[c] - result[c].top : 0.0);
  }
  return result;
}

Vector3 SurfaceColumns::bottom(const Column& column) const {
  Vector3 result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] =
        column.across[0] * axes_[0][k] + column.across[1] * axes_[1][k] + (column.top + column.depth) * into_[k];
  return result;
}

SurfaceColumns::Extent SurfaceColumns::extent() const {
  Place2 low = layout_.place(0), high = low;
  for (int c = 1; c < layout_.count(); ++c)
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], layout_.place(c)[k]);
      high[k] = std::max(high[k], layout_.place(c)[k]);
    }
  const std::size_t longer = high[0] - low[0] >= high[1] - low[1] ? 0 : 1;
  return {longer, high[longer] - low[longer] <= tolerance_, high[1 - longer] - low[1 - longer] <= tolerance_};
}

double maximumDepth(const SurfaceColumns::Profile& profile) {
  double largest = 0.0;
  for (const SurfaceColumns::Column& column : profile) largest = std::max(largest, column.depth);
  return largest;
}

double meanDepth(const SurfaceColumns::Profile& profile) {
  double volume = 0.0, area = 0.0;
  for (const SurfaceColumns::Column& column : profile) {
    volume += column.area * column.depth;
    area += column.area;
  }
  return volume / area;
}

}  // namespace pd
