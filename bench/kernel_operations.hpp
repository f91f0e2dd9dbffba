#pragma once

/// Floating-point operations that the kernels carry out per node of a patch of degrees (m, n) with
/// 8 nodes a direction; a product and a sum fused count 2, a reciprocal square root 1. Counted in
/// the sources by hand. Not counted: sums over the lanes, weights, loads and stores.
namespace bodyline::bench {

/// Net -> rows, shared by the 8 nodes of a column: (order + 1) derivatives of 3 coordinates.
constexpr double rows_operations(int m, int n, int order) {
  return 2.0 * (order + 1) * 3 * (m + 1) * (n + 1) / 8;
}

/// Rows -> `entries` vectors of a jet.
constexpr double entries_operations(int n, int entries) { return 2.0 * entries * 3 * (n + 1); }

constexpr double jets_operations(int m, int n) {
  return rows_operations(m, n, 2) + entries_operations(n, 6);
}

/// Normal 9, D 5, E F G 15, L M N 15, A 6.
constexpr double forms_operations = 50;
/// The steps after the estimate.
constexpr double root_operations = 10;
/// B 3, H and K with their powers of D 6.
constexpr double curvature_tail = 9;
/// B 3, powers of D 2, A^2 / D - 2 B 4, product and weighted sum 3.
constexpr double bending_tail = 12;
/// Adjoints of A, B, D, E ... N 20; of the normal 21; of Suu, Suv, Svv 9; of Su, Sv 44; weights 2.
constexpr double bending_pullback_tail = 96;
/// Derivatives of E F G 36, of L M N 85, of D 10; of A with 3/2 A / D 31; gradient of H squared 7;
/// powers of D 4; product and weighted sum 3.
constexpr double variation_tail = 176;
/// Adjoints of the forms and their slopes 101; through the second form 224, through the first 104;
/// weights 2.
constexpr double variation_pullback_tail = 431;

constexpr double curvature_operations(int m, int n) {
  return rows_operations(m, n, 2) + entries_operations(n, 5) + forms_operations + root_operations +
         curvature_tail;
}
constexpr double bending_operations(int m, int n) {
  return rows_operations(m, n, 2) + entries_operations(n, 5) + forms_operations + root_operations +
         bending_tail;
}
constexpr double bending_pullback_operations(int m, int n) {
  return bending_operations(m, n) + bending_pullback_tail + rows_operations(m, n, 2) +
         entries_operations(n, 5);
}
constexpr double variation_operations(int m, int n) {
  return rows_operations(m, n, 3) + entries_operations(n, 9) + forms_operations + root_operations +
         variation_tail;
}
constexpr double variation_pullback_operations(int m, int n) {
  return variation_operations(m, n) + variation_pullback_tail + rows_operations(m, n, 3) +
         entries_operations(n, 9);
}

}  // namespace bodyline::bench
