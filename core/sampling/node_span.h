// Short spans of nodes of a row, and values, points and cells that go with them.
#pragma once

#include "core/grid/field.h"
#include "core/parallel/simd.h"

namespace whorl {

/// Nodes (i … i + count − 1, j) of a field; at most `size` where Values are filled. Loops work in whole
/// vectors: what they write for the nodes after the last one, up to the next multiple of 64 bytes, has no
/// meaning.
struct NodeSpan {
    static constexpr int size = 64;
    int i;
    int j;
    int count;
};

/// One value for each node of a span.
using Values = Real[NodeSpan::size];

/// Points given by their way from the nodes of a span, in cells.
struct Displacements {
    alignas(64) Values x;
    alignas(64) Values y;
};

/// Points as the cell of samples that holds them and their position in it, 0 to 1.
struct CellPositions {
    alignas(64) Index at[NodeSpan::size];  ///< of sample (i, j) from sample (0, 0), in memory
    alignas(64) Index i[NodeSpan::size];
    alignas(64) Index j[NodeSpan::size];
    alignas(64) Values x;
    alignas(64) Values y;
};

/// Finds the cells of a field that hold points displaced from nodes of a site. Between walls points stop
/// where ghost values do.
using LocateFn = void (*)(const Field&, Site nodes, NodeSpan, const Real* dx, const Real* dy,
                          CellPositions& out);

}  // namespace whorl
