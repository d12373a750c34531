#pragma once

#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace snug {

/// One value for each column of the y-z grid: ny rows along y (index j), each nz long along z (index k).
/// Stored row by row, k fastest.
template <class T>
class Grid {
  public:
    Grid() = default;
    Grid(int ny, int nz, T value = {})
        : ny_(ny), nz_(nz), values_(static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz), value) {}

    [[nodiscard]] int ny() const { return ny_; }
    [[nodiscard]] int nz() const { return nz_; }
    [[nodiscard]] std::size_t size() const { return values_.size(); }
    [[nodiscard]] bool contains(int j, int k) const { return j >= 0 && j < ny_ && k >= 0 && k < nz_; }

    [[nodiscard]] std::size_t index(int j, int k) const {
        assert(contains(j, k));
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(nz_) + static_cast<std::size_t>(k);
    }
    T& operator()(int j, int k) { return values_[index(j, k)]; }
    const T& operator()(int j, int k) const { return values_[index(j, k)]; }
    T& operator[](std::size_t i) { return values_[i]; }
    const T& operator[](std::size_t i) const { return values_[i]; }

    [[nodiscard]] auto begin() { return values_.begin(); }
    [[nodiscard]] auto end() { return values_.end(); }
    [[nodiscard]] auto begin() const { return values_.begin(); }
    [[nodiscard]] auto end() const { return values_.end(); }

    friend bool operator==(const Grid& a, const Grid& b) {
        return a.ny_ == b.ny_ && a.nz_ == b.nz_ && a.values_ == b.values_;
    }

  private:
    int ny_ = 0;
    int nz_ = 0;
    std::vector<T> values_;
};

/// Calls visit(j, k, j2, k2, along_y) once for each pair of columns that share a side;
/// along_y is true where the two are neighbours along y (their common side is sz wide).
template <class T, class Visit>
void for_each_side(const Grid<T>& grid, Visit visit) {
    for (int j = 0; j < grid.ny(); ++j) {
        for (int k = 0; k < grid.nz(); ++k) {
            if (j + 1 < grid.ny()) visit(j, k, j + 1, k, true);
            if (k + 1 < grid.nz()) visit(j, k, j, k + 1, false);
        }
    }
}

}  // namespace snug
