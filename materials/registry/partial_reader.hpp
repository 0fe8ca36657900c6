// Computes that look at the displacements of a few points alone.
#ifndef PD_PARTIAL_READER_HPP
#define PD_PARTIAL_READER_HPP

#include <Teuchos_RCP.hpp>
#include <vector>

#include "Peridigm_Block.hpp"

namespace pd {

/// A host that knows of it may leave displacements elsewhere as they were, where they change little; others need not.
class PartialReader {
 public:
  virtual ~PartialReader() = default;
  /// Marks the points, by local id, whose displacements and places compute() would look at in this state.
  virtual void markRead(const Teuchos::RCP<std::vector<PeridigmNS::Block>>& blocks,
                        std::vector<char>& isRead) const = 0;
};

}  // namespace pd

#endif
