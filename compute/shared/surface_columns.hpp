// How deep a surface has dissolved, column by column: what the computes of depth have in common.
#ifndef PD_SURFACE_COLUMNS_HPP
#define PD_SURFACE_COLUMNS_HPP

#include "column_layout.hpp"
#include "dissolved_metal.hpp"
#include "point_selection.hpp"

namespace pd {

/// A node set at the original surface, and the direction into the metal. At each of its points (or bin of them) starts
/// a column: it and all points behind it, on any rank. A point stands for the length of its column up to where it meets
/// the next, half way where both have the same volume, so spacings may differ along every axis. Depths are exact on
/// lattices with an axis along the direction; elsewhere, in columns of a given width of one to three spacings, each is
/// good to 1.2 spacings and their mean to 0.4 (points jittered by 0.3 spacings).
class SurfaceColumns {
 public:
  static void declareParameters(ParameterDeclarations& declarations);
  SurfaceColumns(const Teuchos::ParameterList& parameters, const ComputeParameters& globalData);

  struct Fields : DissolvedMetal::Fields {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    using DissolvedMetal::Fields::Fields;
  };
  /// Throws std::invalid_argument. Collective, as are profile() and what uses it.
  void initialize(const Blocks& blocks, const Epetra_Comm& comm);

  struct Column {
    Place2 across;       ///< coordinates across the direction, m
    double top;          ///< coordinate along it from which the depth counts, m
    double area;         ///< cross-section, its volume over its length, m2; 0: no metal was in this column
    double firstLength;  ///< of its first layer of points, m
    double depth;        ///< m
    bool isMetal() const { return area > 0.0; }
  };
  using Profile = std::vector<Column>;
  /// Throws std::runtime_error where no column has metal, or none two layers of points.
  Profile profile(const Blocks& blocks, const Epetra_Comm& comm) const;

  /// Place in the body at the depth of a column.
  Vector3 bottom(const Column& column) const;
  struct Extent {
    std::size_t longer;  ///< the axis across the direction along which the columns reach further
    bool isPoint;        ///< one column
    bool isLine;         ///< a row of columns: a plane body
  };
  Extent extent() const;

  /// Calls visit(block number, local id, column number) for the points of the node set that this rank owns.
  template <class Visit>
  void forEachSurfacePoint(Visit&& visit) const {
    for (const Member& member : surface_) visit(member.block, member.id, member.column);
  }

 private:
  struct Member {
    std::size_t block;
    int id;
    std::size_t column;
    double along;         ///< coordinate along the direction, m
    double length = 0.0;  ///< that it stands for, m
    double begin = 0.0;   ///< coordinate where its layer begins, m
    double end = 0.0;     ///< and ends
  };
  struct Layer;  ///< points of a column that are equally far along
  Place2 acrossOf(const double* x) const { return {dot(axes_[0], x), dot(axes_[1], x)}; }
  void findColumns(const Blocks& blocks, const Epetra_Comm& comm);
  struct Box {
    std::vector<double> low, high;  ///< m, along x, y and z
    double length(std::size_t axis) const { return high[axis] - low[axis]; }
  };
  /// Of points that `selection` has, on all ranks.
  Box boxAround(const PointSelection& selection, const Blocks& blocks, const Epetra_Comm& comm) const;
  void requireDirection(const Box& body, const Box& surface) const;
  void findMembers(const Blocks& blocks, const Epetra_Comm& comm);
  void findMetal(const Blocks& blocks, const Epetra_Comm& comm) const;
  std::vector<Layer> findLayers(const Blocks& blocks, const Epetra_Comm& comm) const;
  void fitColumns(std::vector<Layer>& layers) const;
  void setTops(const Blocks& blocks, const Epetra_Comm& comm) const;
  std::vector<DissolvedMetal::View> metalOf(const Blocks& blocks) const;
  std::vector<double> dissolvedBelow(const Blocks& blocks, const Epetra_Comm& comm,
                                     const std::vector<double>& level) const;
  std::vector<double> deepestLiquid(const Blocks& blocks, const Epetra_Comm& comm) const;

  std::string nodeSet_;
  PointSelection points_;
  DissolvedMetal metal_;
  Vector3 into_;
  bool hasDirection_;            ///< given, not the default
  std::array<Vector3, 2> axes_;  ///< across it
  double width_;                 ///< of columns, m; 0: one a point
  bool isDeepest_;
  Fields fields_;
  double tolerance_ = 0.0;
  ColumnLayout layout_;
  std::vector<Member> surface_;             ///< points of the node set
  mutable std::vector<Member> members_;     ///< points of columns, from the node set on
  mutable std::vector<double> firstMetal_;  ///< coordinate where it begins, by column
  mutable Profile columns_;                 ///< without depths
};

/// Of the deepest column, m.
double maximumDepth(const SurfaceColumns::Profile& profile);
/// By cross-section, m.
double meanDepth(const SurfaceColumns::Profile& profile);

}  // namespace pd

#endif
