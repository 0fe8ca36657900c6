// Plug-ins that write the bonds of a few points alone.
#ifndef PD_PARTIAL_WRITER_HPP
#define PD_PARTIAL_WRITER_HPP

#include <cstddef>
#include <map>
#include <vector>

#include "Peridigm_DataManager.hpp"

namespace pd {

/// Bonds `first` to before `last` of a bond field.
struct BondRange {
  std::size_t first, last;
};

/// A host that knows of it copies no more of them than it must at the end of a step; others need not.
class PartialWriter {
 public:
  virtual ~PartialWriter() = default;
  /// Of two-step bond fields, by id, that no other plug-in writes: the bonds at which NP1 may differ from N by what
  /// this one has done since N was last made of NP1. A field that is left out may differ anywhere.
  virtual std::map<int, std::vector<BondRange>> bondsWritten(PeridigmNS::DataManager& data) const = 0;
};

}  // namespace pd

#endif
