#include "frontal_factor.hpp"

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <numeric>

namespace pd {

namespace {

using Blas = Teuchos::BLAS<int, double>;
using Lapack = Teuchos::LAPACK<int, double>;

// Of its entry of the matrix: what follows from a smaller pivot is mostly rounding (parts that hold others with a 1e-10
// of their stiffness: times of events off by a hundredth).
constexpr double negligible = 1e-9;
// Columns of a front that are eliminated at a time.
constexpr int blockWidth = 96;
// Columns of the inverse that are found at a time.
constexpr int mostColumns = 256;

std::size_t size(int n) { return static_cast<std::size_t>(n); }

}  // namespace

FrontalFactor::FrontalFactor(const PartStiffness& part, const std::vector<std::size_t>& ends)
    : part_(part), frontOf_(part.nPoints()), seen_(part.nPoints(), -1), local_(size(part.nUnknowns())) {
  sortSprings();
  findFronts(ends);
}

void FrontalFactor::sortSprings() {
  firstSpring_.assign(part_.nPoints() + 1, 0);
  for (const PartStiffness::Spring& spring : part_.springs()) ++firstSpring_[size(spring.from) + 1];
  std::partial_sum(firstSpring_.begin(), firstSpring_.end(), firstSpring_.begin());
  std::vector<std::size_t> next = firstSpring_;
  springs_.resize(part_.springs().size());
  for (const PartStiffness::Spring& spring : part_.springs()) springs_[next[size(spring.from)]++] = spring;
}

void FrontalFactor::findFronts(const std::vector<std::size_t>& ends) {
  int first = 0;
  const auto add = [&](std::size_t end) {
    Front& front = fronts_.emplace_back();
    front.firstPoint = first;
    front.endPoint = first = static_cast<int>(end);
    for (int p = front.firstPoint; p < first; ++p) frontOf_[size(p)] = static_cast<int>(fronts_.size()) - 1;
  };
  std::for_each(ends.begin(), ends.end(), add);
  add(part_.nPoints());
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    Front& front = fronts_[f];
    front.border = borderOf(front);
    const auto addUnknowns = [&](int p) {
      for (int unknown = part_.firstUnknown(size(p)); unknown < part_.firstUnknown(size(p) + 1); ++unknown)
        front.unknowns.push_back(unknown);
    };
    for (int p = front.firstPoint; p < front.endPoint; ++p) addUnknowns(p);
    front.width = static_cast<int>(front.unknowns.size());
    std::for_each(front.border.begin(), front.border.end(), addUnknowns);
    if (front.border.empty()) continue;
    front.parent = frontOf_[size(front.border.front())];
    fronts_[size(front.parent)].children.push_back(static_cast<int>(f));
  }
}

std::vector<int> FrontalFactor::borderOf(const Front& front) {
  std::vector<int> border;
  const auto add = [&](int p) {
    if (p < front.endPoint || seen_[size(p)] == front.endPoint) return;
    seen_[size(p)] = front.endPoint;
    border.push_back(p);
  };
  for (std::size_t s = firstSpring_[size(front.firstPoint)]; s < firstSpring_[size(front.endPoint)]; ++s)
    add(springs_[s].to);
  for (const int child : front.children)
    std::for_each(fronts_[size(child)].border.begin(), fronts_[size(child)].border.end(), add);
  const std::vector<int>& dense = part_.densePlaces();
  const auto isOwn = [&](int p) { return p >= front.firstPoint && p < front.endPoint; };
  if (std::any_of(dense.begin(), dense.end(), isOwn)) std::for_each(dense.begin(), dense.end(), add);
  std::sort(border.begin(), border.end());
  return border;
}

std::string FrontalFactor::eliminate(bool keepsColumns) {
  for (Front& front : fronts_) {
    if (!eliminate(front)) return singular;
    if (!keepsColumns && front.parent >= 0) front.columns.reset();
  }
  return "";
}

bool FrontalFactor::eliminate(Front& front) {
  const int n = static_cast<int>(front.unknowns.size()), nBorder = front.nBorder();
  for (int k = 0; k < n; ++k) local_[size(front.unknowns[size(k)])] = k;
  front.columns.reset(new double[size(n) * size(front.width)]());
  addPoints(front);
  addChildren(front, true);
  const bool isLast = &front == &fronts_.back();
  if (!isLast && !factorOwn(front)) return false;
  front.rest.reset(new double[size(nBorder) * size(nBorder)]);
  if (nBorder > 0)
    Blas().SYRK(Teuchos::LOWER_TRI, Teuchos::NO_TRANS, nBorder, front.width, -1.0, &front.columns[size(front.width)], n,
                0.0, front.rest.get(), nBorder);
  addChildren(front, false);
  for (const int child : front.children) fronts_[size(child)].rest.reset();
  return true;
}

/// What is at a front's own points, and between them and later ones.
void FrontalFactor::addPoints(const Front& front) {
  const std::size_t n = front.unknowns.size();
  const auto add = [&](int row, int column, double value) {
    front.columns[size(local_[size(column)]) * n + size(local_[size(row)])] += value;
  };
  for (int p = front.firstPoint; p < front.endPoint; ++p) part_.forEachEntryOfPoint(size(p), add);
  for (std::size_t s = firstSpring_[size(front.firstPoint)]; s < firstSpring_[size(front.endPoint)]; ++s)
    part_.forEachEntry(springs_[s], add);
  const std::vector<int>& dense = part_.denseUnknowns();
  const int first = part_.firstUnknown(size(front.firstPoint)), end = part_.firstUnknown(size(front.endPoint));
  for (std::size_t c = 0; c < dense.size(); ++c) {
    if (dense[c] < first || dense[c] >= end) continue;
    for (std::size_t r = 0; r < dense.size(); ++r)
      if (dense[r] >= dense[c]) add(dense[r], dense[c], part_.denseValue(r, c));
  }
}

/// What its children leave, to its own columns or to the rest.
void FrontalFactor::addChildren(Front& front, bool toOwn) {
  const int n = static_cast<int>(front.unknowns.size()), width = front.width, nBorder = front.nBorder();
  for (const int which : front.children) {
    const Front& child = fronts_[size(which)];
    const int m = child.nBorder();
    const int* unknowns = child.unknowns.data() + child.width;
    const int nOwn =
        static_cast<int>(std::lower_bound(unknowns, unknowns + m, part_.firstUnknown(size(front.endPoint))) - unknowns);
    for (int c = toOwn ? 0 : nOwn; c < (toOwn ? nOwn : m); ++c) {
      const int column = local_[size(unknowns[c])];
      double* to =
          toOwn ? &front.columns[size(column) * size(n)] : &front.rest[size(column - width) * size(nBorder)] - width;
      const double* from = &child.rest[size(c) * size(m)];
      for (int r = c; r < m; ++r) to[local_[size(unknowns[r])]] += from[r];
    }
  }
}

/// Block after block of columns, by products of matrices: in place of its diagonal block each has that one's inverse.
/// False where the own points are not held in place.
bool FrontalFactor::factorOwn(Front& front) {
  const int n = static_cast<int>(front.unknowns.size()), width = front.width;
  std::vector<double> before;
  for (int c = 0; c < width; ++c) before.push_back(front.columns[size(c) * size(n + 1)]);
  for (int first = 0; first < width; first += blockWidth) {
    const int w = std::min(blockWidth, width - first), below = n - first - w;
    double *rows = &front.columns[size(first)], *block = &rows[size(first) * size(n)];
    if (first > 0)
      Blas().GEMM(Teuchos::NO_TRANS, Teuchos::TRANS, n - first, w, first, -1.0, rows, n, rows, n, 1.0, block, n);
    int info = 0;
    Lapack().POTRF('L', w, block, n, &info);
    if (info != 0) return false;
    for (int c = 0; c < w; ++c) {
      const double pivot = block[size(c) * size(n + 1)];
      if (!(pivot * pivot > negligible * before[size(first + c)])) return false;
    }
    Lapack().TRTRI('L', 'N', w, block, n, &info);
    if (below > 0)
      Blas().TRMM(Teuchos::RIGHT_SIDE, Teuchos::LOWER_TRI, Teuchos::TRANS, Teuchos::NON_UNIT_DIAG, below, w, 1.0, block,
                  n, block + w, n);
  }
  return true;
}

std::vector<double> FrontalFactor::takeLeft() {
  const Front& last = fronts_.back();
  const std::size_t n = size(last.width);
  std::vector<double> left(n * n);
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t r = c; r < n; ++r) left[c * n + r] = left[r * n + c] = last.columns[c * n + r];
  fronts_.clear();
  return left;
}

/// Of the last front; both triangles.
bool FrontalFactor::invertLeft() {
  Front& last = fronts_.back();
  const std::size_t n = size(last.width);
  double* values = last.columns.get();
  std::vector<double> before;
  for (std::size_t c = 0; c < n; ++c) before.push_back(values[c * (n + 1)]);
  int info = 0;
  Lapack().POTRF('L', last.width, values, last.width, &info);
  if (info != 0) return false;
  for (std::size_t c = 0; c < n; ++c)
    if (!(values[c * (n + 1)] * values[c * (n + 1)] > negligible * before[c])) return false;
  Lapack().POTRI('L', last.width, values, last.width, &info);
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t r = c + 1; r < n; ++r) values[r * n + c] = values[c * n + r];
  return info == 0;
}

/// Those that unknowns belong to, and all that these wait for.
std::vector<char> FrontalFactor::frontsAbove(const std::vector<int>& unknowns) const {
  std::vector<char> has(size(part_.nUnknowns()), 0), isAbove(fronts_.size(), 0);
  for (const int unknown : unknowns) has[size(unknown)] = 1;
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    const Front& front = fronts_[f];
    for (int k = 0; k < front.width; ++k)
      if (has[size(front.unknowns[size(k)])] != 0) isAbove[f] = 1;
    if (isAbove[f] != 0 && front.parent >= 0) isAbove[size(front.parent)] = 1;
  }
  return isAbove;
}

/// How its own unknowns move where those of its border do, in `count` cases.
void FrontalFactor::substitute(const Front& front, int count) {
  const int n = static_cast<int>(front.unknowns.size()), nBorder = front.nBorder(), width = front.width;
  if (width == 0) return;
  std::vector<double> border;
  for (int k = width; k < n; ++k) {
    const double* from = &moved_[size(front.unknowns[size(k)]) * size(count)];
    border.insert(border.end(), from, from + count);
  }
  double* own = &moved_[size(front.unknowns.front()) * size(count)];
  const double* columns = front.columns.get();
  const auto subtract = [&](const double* moved, int row, int nRows, int first, int w) {
    if (nRows > 0)
      Blas().GEMM(Teuchos::NO_TRANS, Teuchos::NO_TRANS, count, w, nRows, -1.0, moved, count,
                  &columns[size(first) * size(n) + size(row)], n, 1.0, &own[size(first) * size(count)], count);
  };
  for (int first = (width - 1) / blockWidth * blockWidth; first >= 0; first -= blockWidth) {
    const int w = std::min(blockWidth, width - first), end = first + w;
    subtract(border.data(), width, nBorder, first, w);
    subtract(&own[size(end) * size(count)], end, width - end, first, w);
    Blas().TRMM(Teuchos::RIGHT_SIDE, Teuchos::LOWER_TRI, Teuchos::NO_TRANS, Teuchos::NON_UNIT_DIAG, count, w, 1.0,
                &columns[size(first) * size(n + 1)], n, &own[size(first) * size(count)], count);
  }
}

std::vector<double> FrontalFactor::columnsOfInverse(const std::vector<int>& rows) {
  std::vector<double> columns;
  if (!invertLeft()) return columns;
  const Front& last = fronts_.back();
  const std::vector<char> isAbove = frontsAbove(rows);
  columns.resize(size(last.width) * rows.size());
  for (int first = 0; first < last.width; first += mostColumns) {
    const int count = std::min(mostColumns, last.width - first);
    moved_.assign(size(part_.nUnknowns()) * size(count), 0.0);
    for (int k = 0; k < last.width; ++k)
      std::copy_n(&last.columns[size(k) * size(last.width) + size(first)], count,
                  &moved_[size(last.unknowns[size(k)]) * size(count)]);
    for (std::size_t f = fronts_.size() - 1; f-- > 0;)
      if (isAbove[f] != 0) substitute(fronts_[f], count);
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (int c = 0; c < count; ++c)
        columns[size(first + c) * rows.size() + r] = moved_[size(rows[r]) * size(count) + size(c)];
  }
  fronts_.clear();
  return columns;
}

}  // namespace pd
