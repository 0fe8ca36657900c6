// Rows of a nonlocal operator of a flow, in little memory.
#ifndef PD_FLOW_OPERATOR_HPP
#define PD_FLOW_OPERATOR_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace pd {

/// A row for each owned fluid point: N weights of each point that has a part in it, and a constant from the boundaries.
/// Of nine weights (3a + b) many rows have one or three that differ, and store no more. Rows with the same weights, to
/// rounding, at the same offsets of local ids, as most have on lattices, share one stencil.
template <std::size_t N>
class FlowOperator {
 public:
  struct Term {
    int point;  ///< local id of a fluid point, owned or ghost
    std::array<double, N> weights;
  };
  enum class Form : char {
    Whole,     ///< all N
    Identity,  ///< w of diag(w, w, w)
    SameRows   ///< w[b] of w[3a + b]
  };
  /// A row as it is stored.
  struct Row {
    Form form;
    std::size_t count;
    int point;             ///< local id of the row's own point
    const int* offsets;    ///< [count] of local ids from it
    const double* values;  ///< 1, 3 or N of each point
    int pointOf(std::size_t k) const { return point + offsets[k]; }
  };
  /// What a source has in the constant of a row. Its weights are those that a point of this velocity would have.
  struct Share {
    std::size_t row, source;
    std::array<double, N> weights;
  };

  std::vector<std::array<double, N>> constants;
  std::vector<Share> shares;

  /// Of the row that close() ends.
  void add(int point, const std::array<double, N>& weights) { terms_.push_back({point, weights}); }
  void addShare(std::size_t source, const std::array<double, N>& weights) {
    shares.push_back({constants.size(), source, weights});
  }
  void close(int point, const std::array<double, N>& constant) {
    addUp();
    points_.push_back(point);
    stencilOf_.push_back(stencilAround(point));
    terms_.clear();
    constants.push_back(constant);
  }
  /// A whole row, of a point whose surroundings are those of an earlier row, with no constant.
  void repeat(std::size_t row, int point) {
    points_.push_back(point);
    stencilOf_.push_back(stencilOf_[row]);
    constants.push_back({});
  }
  /// Before the first row: those of `earlier`, whose rows keep() can take over then, and which is of no use otherwise.
  void takeStencils(FlowOperator& earlier) {
    forms_ = std::move(earlier.forms_);
    offsetsBefore_ = std::move(earlier.offsetsBefore_);
    valuesBefore_ = std::move(earlier.valuesBefore_);
    offsets_ = std::move(earlier.offsets_);
    values_ = std::move(earlier.values_);
  }
  /// A whole row of `earlier`, without its shares.
  void keep(const FlowOperator& earlier, std::size_t row, int point) {
    points_.push_back(point);
    stencilOf_.push_back(earlier.stencilOf_[row]);
    constants.push_back(earlier.constants[row]);
  }
  /// After the last row: forgets what finds equal ones.
  void finish() { stencilByKey_ = {}; }
  /// So many rows will come, about as long as those so far.
  void expect(std::size_t nRows) {
    const double share = 1.02 * static_cast<double>(nRows) / static_cast<double>(std::max<std::size_t>(1, size()));
    offsets_.reserve(static_cast<std::size_t>(share * static_cast<double>(offsets_.size())));
    values_.reserve(static_cast<std::size_t>(share * static_cast<double>(values_.size())));
  }

  std::size_t size() const { return points_.size(); }
  std::size_t nStencils() const { return forms_.size(); }
  Row row(std::size_t r) const {
    const auto s = static_cast<std::size_t>(stencilOf_[r]);
    return {forms_[s], offsetsBefore_[s + 1] - offsetsBefore_[s], points_[r], offsets_.data() + offsetsBefore_[s],
            values_.data() + valuesBefore_[s]};
  }
  /// Each point once.
  template <class Use>
  void forEach(std::size_t r, const Use& use) const {
    const Row stored = row(r);
    const auto width = static_cast<std::size_t>(widthOf(stored.form));
    for (std::size_t k = 0; k < stored.count; ++k)
      use(Term{stored.pointOf(k), wholeOf(stored.form, stored.values + width * k)});
  }

 private:
  static std::ptrdiff_t widthOf(Form form) { return form == Form::Whole ? N : form == Form::Identity ? 1 : 3; }

  static std::array<double, N> wholeOf(Form form, const double* values) {
    std::array<double, N> weights{};
    if constexpr (N == 9)
      if (form != Form::Whole) {
        for (std::size_t a = 0; a < 3; ++a)
          for (std::size_t b = 0; b < 3; ++b)
            weights[3 * a + b] = form == Form::SameRows ? values[b] : a == b ? values[0] : 0.0;
        return weights;
      }
    std::copy(values, values + N, weights.begin());
    return weights;
  }

  Form formOfTerms() const {
    if constexpr (N == 9)
      for (const Form form : {Form::Identity, Form::SameRows})
        if (std::all_of(terms_.begin(), terms_.end(),
                        [&](const Term& term) { return wholeOf(form, term.weights.data()) == term.weights; }))
          return form;
    return Form::Whole;
  }

  /// Terms of one point become one.
  void addUp() {
    std::stable_sort(terms_.begin(), terms_.end(), [](const Term& a, const Term& b) { return a.point < b.point; });
    std::size_t last = 0;
    for (std::size_t k = 1; k < terms_.size(); ++k) {
      if (terms_[k].point != terms_[last].point)
        terms_[++last] = terms_[k];
      else
        for (std::size_t n = 0; n < N; ++n) terms_[last].weights[n] += terms_[k].weights[n];
    }
    if (!terms_.empty()) terms_.resize(last + 1);
  }

  int stencilAround(int point) {
    const Form form = formOfTerms();
    const std::size_t firstOffset = offsets_.size(), firstValue = values_.size();
    for (const Term& term : terms_) {
      offsets_.push_back(term.point - point);
      values_.insert(values_.end(), term.weights.begin(), term.weights.begin() + widthOf(form));
    }
    const auto nStencils = static_cast<int>(forms_.size());
    const auto [known, isNew] = stencilByKey_.emplace(keyOf(form, firstOffset, firstValue), nStencils);
    if (!isNew && isLike(static_cast<std::size_t>(known->second), form, firstOffset, firstValue)) {
      offsets_.resize(firstOffset);
      values_.resize(firstValue);
      return known->second;
    }
    forms_.push_back(form);
    offsetsBefore_.push_back(offsets_.size());
    valuesBefore_.push_back(values_.size());
    return nStencils;
  }

  double largestFrom(std::size_t firstValue) const {
    double largest = 0.0;
    for (std::size_t k = firstValue; k < values_.size(); ++k) largest = std::max(largest, std::abs(values_[k]));
    return largest;
  }

  /// Of the stencil at the end of offsets_ and values_: the same where values differ by rounding, but for few that have
  /// no partner for it.
  std::size_t keyOf(Form form, std::size_t firstOffset, std::size_t firstValue) const {
    auto key = static_cast<std::size_t>(form);
    const auto mix = [&](long long part) {
      key = (key ^ static_cast<std::size_t>(part)) * 0x9E3779B97F4A7C15ULL;
      key ^= key >> 29U;
    };
    for (std::size_t k = firstOffset; k < offsets_.size(); ++k) mix(offsets_[k]);
    constexpr double fineness = 61803.39887;  // simple fractions are not half way between its multiples
    const double largest = largestFrom(firstValue);
    if (largest > 0.0)
      for (std::size_t k = firstValue; k < values_.size(); ++k) mix(std::llround(values_[k] / largest * fineness));
    return key;
  }

  bool isLike(std::size_t stencil, Form form, std::size_t firstOffset, std::size_t firstValue) const {
    constexpr double rounding = 1e-11;
    const std::size_t count = offsets_.size() - firstOffset, width = values_.size() - firstValue;
    if (forms_[stencil] != form || offsetsBefore_[stencil + 1] - offsetsBefore_[stencil] != count) return false;
    const int* offsets = offsets_.data() + offsetsBefore_[stencil];
    if (!std::equal(offsets, offsets + count, offsets_.data() + firstOffset)) return false;
    const double *known = values_.data() + valuesBefore_[stencil], *found = values_.data() + firstValue;
    const double most = rounding * largestFrom(firstValue);
    return std::equal(known, known + width, found, [&](double a, double b) { return std::abs(a - b) <= most; });
  }

  std::vector<Term> terms_;     ///< of the row that is being made
  std::vector<int> points_;     ///< [rows]
  std::vector<int> stencilOf_;  ///< [rows]
  std::vector<Form> forms_;     ///< [stencils]
  std::vector<std::size_t> offsetsBefore_{0}, valuesBefore_{0};
  std::vector<int> offsets_;
  std::vector<double> values_;
  std::unordered_map<std::size_t, int> stencilByKey_;
};

}  // namespace pd

#endif
