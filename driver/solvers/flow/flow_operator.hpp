// Rows of a nonlocal operator of a flow, in little memory.
#ifndef PD_FLOW_OPERATOR_HPP
#define PD_FLOW_OPERATOR_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace pd {

/// A row for each owned fluid point: N weights of each point that has a part in it, and a constant from the boundaries.
/// Of nine weights (3a + b) many rows have one or three that differ, and store no more.
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
    const int* points;
    const double* values;  ///< 1, 3 or N of each point
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
  void close(const std::array<double, N>& constant) {
    addUp();
    const Form form = formOfTerms();
    for (const Term& term : terms_) {
      points_.push_back(term.point);
      values_.insert(values_.end(), term.weights.begin(), term.weights.begin() + widthOf(form));
    }
    terms_.clear();
    forms_.push_back(form);
    pointsBefore_.push_back(points_.size());
    valuesBefore_.push_back(values_.size());
    constants.push_back(constant);
  }
  /// So many rows will come, about as long as those so far.
  void expect(std::size_t nRows) {
    const double share = 1.02 * static_cast<double>(nRows) / static_cast<double>(std::max<std::size_t>(1, size()));
    points_.reserve(static_cast<std::size_t>(share * static_cast<double>(points_.size())));
    values_.reserve(static_cast<std::size_t>(share * static_cast<double>(values_.size())));
  }

  std::size_t size() const { return forms_.size(); }
  Row row(std::size_t r) const {
    return {forms_[r], pointsBefore_[r + 1] - pointsBefore_[r], points_.data() + pointsBefore_[r],
            values_.data() + valuesBefore_[r]};
  }
  /// Each point once.
  template <class Use>
  void forEach(std::size_t r, const Use& use) const {
    const Row stored = row(r);
    const auto width = static_cast<std::size_t>(widthOf(stored.form));
    for (std::size_t k = 0; k < stored.count; ++k)
      use(Term{stored.points[k], wholeOf(stored.form, stored.values + width * k)});
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

  std::vector<Term> terms_;  ///< of the row that is being made
  std::vector<Form> forms_;
  std::vector<std::size_t> pointsBefore_{0}, valuesBefore_{0};
  std::vector<int> points_;
  std::vector<double> values_;
};

}  // namespace pd

#endif
