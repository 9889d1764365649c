// Cells that a thin wall cuts off from the coarse cell they lie in, and the coarse cells that take them
// instead.
#pragma once

#include <cstdint>
#include <vector>

namespace whorl {

/// The shape of one grid and how its rows follow each other.
struct LevelShape {
    int nx = 0;
    int ny = 0;
    bool wraps_x = false;
    bool wraps_y = false;

    /// The row at j, wrapped where y is; −1 where there is none.
    int row(int j) const {
        if (j >= 0 && j < ny) return j;
        return wraps_y ? (j % ny + ny) % ny : -1;
    }
};

/// Where four children are not connected inside their coarse cell, the larger part keeps it. Each other child
/// goes to the coarse cell behind one of its open faces. So both sides of a wall of one cell stay apart on
/// coarse grids, where they would else be one, and corrections on one side leak to the other.
class Aggregation {
  public:
    struct Orphan {
        int i, j;                     ///< the child
        int parent_i, parent_j = -1;  ///< −1: none takes it, and smoothing alone corrects it
    };
    struct Range {
        const Orphan* first;
        const Orphan* last;
        const Orphan* begin() const { return first; }
        const Orphan* end() const { return last; }
    };

    /// @param open_x `open_x(i, j)`, the coefficient of the fine face between cells i − 1 and i; `open_y`
    /// likewise
    template <class X, class Y>
    void find(const LevelShape& fine, const LevelShape& coarse, X&& open_x, Y&& open_y);
    void clear();

    /// Orphans of a row of children, and those that a row of new parents has.
    Range in_row(int j) const { return range(of_row_, row_starts_, j); }
    Range by_row(int parent_j) const { return range(of_parent_, parent_starts_, parent_j); }

    /// Moves the faces of orphans to their new parents: calls `change(i0, j0, i1, j1, amount)` for
    /// pairs of coarse cells, the second one to the right of or above the first one or wrapped.
    template <class X, class Y, class Change>
    void move_faces(X&& open_x, Y&& open_y, Change&& change) const;

  private:
    /// Who has a child: the cell it lies in, one of that cell's neighbours, or none.
    enum ParentSide : std::uint8_t { Own, West, East, South, North, None, Undecided };
    struct Cell {
        int i, j;
        bool operator==(const Cell&) const = default;
    };

    static Range range(const std::vector<Orphan>& all, const std::vector<int>& starts, int row) {
        if (starts.empty()) return {nullptr, nullptr};
        return {all.data() + starts[row], all.data() + starts[row + 1]};
    }
    ParentSide& parent_side(Cell c) { return parent_sides_[static_cast<std::size_t>(c.j) * fine_.nx + c.i]; }
    ParentSide parent_side(Cell c) const {
        return parent_sides_[static_cast<std::size_t>(c.j) * fine_.nx + c.i];
    }
    /// The cell beside one of the fine grid; {−1, −1} outside a box.
    Cell beside(Cell c, ParentSide side) const;
    Cell parent(Cell child) const;
    /// Whether two children of the coarse cell that begins at `corner` are connected inside it and the ring
    /// of fine cells around it. If so, they differ by little, and may share their coarse cell after all.
    template <class X, class Y>
    bool meets_nearby(Cell from, Cell to, Cell corner, X&& open_x, Y&& open_y) const;
    template <class X, class Y>
    static float face(Cell c, ParentSide side, X&& open_x, Y&& open_y) {
        return side == West    ? open_x(c.i, c.j)
               : side == East  ? open_x(c.i + 1, c.j)
               : side == South ? open_y(c.i, c.j)
                               : open_y(c.i, c.j + 1);
    }
    static ParentSide outward(Cell child, bool across) {
        if (across) return child.i % 2 == 0 ? West : East;
        return child.j % 2 == 0 ? South : North;
    }
    /// Notes the children of the coarse cell that begins at `corner` which are not connected to its larger
    /// part.
    template <class X, class Y>
    void find_orphans(Cell corner, X&& open_x, Y&& open_y);
    template <class X, class Y>
    void find_parents(X&& open_x, Y&& open_y);
    void list();

    LevelShape fine_, coarse_;
    std::vector<ParentSide> parent_sides_;
    std::vector<Cell> orphans_;
    std::vector<Orphan> of_row_, of_parent_;
    std::vector<int> row_starts_, parent_starts_;
};

template <class X, class Y>
void Aggregation::find(const LevelShape& fine, const LevelShape& coarse, X&& open_x, Y&& open_y) {
    clear();
    fine_ = fine;
    coarse_ = coarse;
    // Around a ring of two coarse cells, or of an odd number of fine ones, neighbours are not what they seem.
    if ((fine.wraps_x && (coarse.nx <= 2 || fine.nx % 2)) ||
        (fine.wraps_y && (coarse.ny <= 2 || fine.ny % 2)))
        return;
    for (int j = 0; j < fine.ny; j += 2) {
        for (int i = 0; i < fine.nx; i += 2) find_orphans({i, j}, open_x, open_y);
    }
    find_parents(open_x, open_y);
    list();
}

template <class X, class Y>
void Aggregation::find_orphans(Cell corner, X&& open_x, Y&& open_y) {
    const int i = corner.i, j = corner.j;
    const bool two_x = i + 1 < fine_.nx;
    const bool two_y = j + 1 < fine_.ny;
    const bool low = two_x && open_x(i + 1, j) > 0;
    const bool high = two_x && two_y && open_x(i + 1, j + 1) > 0;
    const bool left = two_y && open_y(i, j + 1) > 0;
    const bool right = two_x && two_y && open_y(i + 1, j + 1) > 0;
    if (low + high + left + right >= 3) return;
    // Children 0, 1 below and 2, 3 above; a part is known by its first child.
    int part[4] = {0, 1, 2, 3};
    if (low) part[1] = 0;
    if (left) part[2] = 0;
    if (high) part[3] = part[2];
    if (right) part[3] = high ? part[3] : part[1];
    if (high && right && part[1] != part[2])
        part[1] = part[2] = part[3] = part[1] < part[2] ? part[1] : part[2];
    const Cell cells[4] = {{i, j}, {i + 1, j}, {i, j + 1}, {i + 1, j + 1}};
    int size[4] = {};
    for (int k = 0; k < 4; ++k) {
        const Cell c = cells[k];
        if (c.i >= fine_.nx || c.j >= fine_.ny) continue;
        const bool fluid = open_x(c.i, c.j) > 0 || open_x(c.i + 1, c.j) > 0 || open_y(c.i, c.j) > 0 ||
                           open_y(c.i, c.j + 1) > 0;
        if (fluid) ++size[part[k]];
    }
    int main = 0;
    for (int k = 1; k < 4; ++k) main = size[k] > size[main] ? k : main;
    for (int k = 0; k < 4; ++k) {
        if (part[k] == main || size[part[k]] == 0) continue;
        const Cell c = cells[k];
        if (c.i >= fine_.nx || c.j >= fine_.ny) continue;
        if (meets_nearby(c, cells[main], corner, open_x, open_y)) continue;
        if (parent_sides_.empty()) parent_sides_.assign(static_cast<std::size_t>(fine_.nx) * fine_.ny, Own);
        parent_side(c) = Undecided;
        orphans_.push_back(c);
    }
}

template <class X, class Y>
void Aggregation::find_parents(X&& open_x, Y&& open_y) {
    // To the cell beside it, if that keeps its own parent; then to where the other child of the same part
    // went.
    for (const Cell c : orphans_) {
        float most = 0;
        ParentSide to = Undecided;
        for (const bool across : {true, false}) {
            const ParentSide side = outward(c, across);
            const float open = face(c, side, open_x, open_y);
            if (!(open > most) || parent_side(beside(c, side)) != Own) continue;
            most = open;
            to = side;
        }
        parent_side(c) = to;
    }
    for (const Cell c : orphans_) {
        if (parent_side(c) != Undecided) continue;
        for (const bool across : {true, false}) {
            const ParentSide side = outward(c, across);
            const ParentSide inward = side == West    ? East
                                      : side == East  ? West
                                      : side == South ? North
                                                      : South;
            if (!(face(c, inward, open_x, open_y) > 0)) continue;
            const ParentSide sibling = parent_side(beside(c, inward));
            if (sibling >= West && sibling <= North) parent_side(c) = sibling;
        }
    }
    for (const Cell c : orphans_) {
        if (parent_side(c) == Undecided) parent_side(c) = None;
    }
}

template <class X, class Y>
bool Aggregation::meets_nearby(Cell from, Cell to, Cell corner, X&& open_x, Y&& open_y) const {
    constexpr int width = 4;
    Cell todo[width * width] = {from};
    bool seen[width][width] = {};
    seen[from.j - corner.j + 1][from.i - corner.i + 1] = true;
    // Positions are kept unwrapped, so that the window is a square; faces are looked up at the wrapped ones.
    for (int count = 1; count > 0;) {
        const Cell at = todo[--count];
        if (at == to) return true;
        const Cell c{at.i < 0 || at.i >= fine_.nx
                         ? beside({at.i < 0 ? 0 : fine_.nx - 1, 0}, at.i < 0 ? West : East).i
                         : at.i,
                     at.j < 0 || at.j >= fine_.ny
                         ? beside({0, at.j < 0 ? 0 : fine_.ny - 1}, at.j < 0 ? South : North).j
                         : at.j};
        for (const ParentSide side : {West, East, South, North}) {
            const Cell next{at.i + (side == East) - (side == West), at.j + (side == North) - (side == South)};
            const int x = next.i - corner.i + 1;
            const int y = next.j - corner.j + 1;
            if (x < 0 || y < 0 || x >= width || y >= width || seen[y][x]) continue;
            if (!(face(c, side, open_x, open_y) > 0)) continue;
            seen[y][x] = true;
            todo[count++] = next;
        }
    }
    return false;
}

template <class X, class Y, class Change>
void Aggregation::move_faces(X&& open_x, Y&& open_y, Change&& change) const {
    for (const Cell c : orphans_) {
        for (const ParentSide side : {West, East, South, North}) {
            const float open = face(c, side, open_x, open_y);
            if (!(open > 0)) continue;
            const Cell other = beside(c, side);
            const bool both = parent_side(other) != Own;
            if (both && (other.j < c.j || (other.j == c.j && other.i < c.i))) continue;  // once is enough
            const Cell lies{c.i / 2, c.j / 2};
            const Cell other_lies{other.i / 2, other.j / 2};
            if (!(lies == other_lies)) change(lies.i, lies.j, other_lies.i, other_lies.j, -open / 2);
            const Cell goes = parent(c);
            const Cell other_goes = parent(other);
            if (goes.i >= 0 && other_goes.i >= 0)
                change(goes.i, goes.j, other_goes.i, other_goes.j, open / 2);
        }
    }
}

}  // namespace whorl
