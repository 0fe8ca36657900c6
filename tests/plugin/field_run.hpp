// Plug-ins under the eyes of a host that knows their tables of fields, and looks at every value of every field.
#ifndef PD_TESTS_FIELD_RUN_HPP
#define PD_TESTS_FIELD_RUN_HPP

#include "step_run.hpp"

namespace pdtest {

/// What a table leaves unsaid: labels, units, meanings that are empty. A line each; empty: nothing.
std::string gapsIn(const pd::FieldTable& table);

/// Where FieldIds() and the fields to synchronise differ from the table of a plug-in, and what it has written into
/// fields, or into values of the step before, that the table does not give it. A line each; empty: nothing.
std::string brokenFieldContract(const Sample& sample, PluginKind kind);

/// Parameters of a compute for the plate of brokenFieldContract(const ComputeSample&).
struct ComputeSample {
  std::string plugin;
  Teuchos::ParameterList parameters;
};
/// One a registered compute.
std::vector<ComputeSample> computeSamples();

/// The same for a compute on a plate that dissolves; and what it says that it writes and does not.
std::string brokenFieldContract(const ComputeSample& sample);

inline void PrintTo(const ComputeSample& sample, std::ostream* out) { *out << sample.plugin; }

}  // namespace pdtest

#endif
