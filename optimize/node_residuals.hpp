#pragma once

#include <cmath>

namespace bodyline::optimize {

/// The energies at one point as sums of squares, for any arithmetic type. `jet` holds the partial
/// derivatives of the surface as 3 numbers each, in the order Su, Sv, Suu, Suv, Svv, and for the
/// variation also Suuu, Suuv, Suvv, Svvv.

/// First and second fundamental forms of a jet, with the unnormalised normal n = Su x Sv.
template <class T>
struct Forms {
  T e, f, g;  // first form
  T n[3], d;  // n and |n|^2
  T l, m, k;  // n . Suu, n . Suv, n . Svv
};

template <class T>
T inner(const T* a, const T* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
Forms<T> forms(const T* jet) {
  const T *su = jet, *sv = jet + 3;
  Forms<T> r;
  r.e = inner(su, su);
  r.f = inner(su, sv);
  r.g = inner(sv, sv);
  r.n[0] = su[1] * sv[2] - su[2] * sv[1];
  r.n[1] = su[2] * sv[0] - su[0] * sv[2];
  r.n[2] = su[0] * sv[1] - su[1] * sv[0];
  r.d = inner(r.n, r.n);
  r.l = inner(r.n, jet + 6);
  r.m = inner(r.n, jet + 9);
  r.k = inner(r.n, jet + 12);
  return r;
}

/// Three residuals whose squares sum to (k1^2 + k2^2) |n|: the second form in an orthonormal frame,
/// times sqrt |n|.
template <class T>
void bending_residuals(const T* jet, T* residual) {
  using std::sqrt;
  const Forms<T> q = forms(jet);
  // The frame: t1 along Su, t2 = Sv less its part along Su. |t2| |Su| = |n|.
  const T skew = q.f / q.e;
  const T root = sqrt(sqrt(q.d));      // sqrt |n|
  const T scale = root / sqrt(q.d);    // second form per |n|, times sqrt |n|
  const T m = q.m - skew * q.l;        // II(Su, t2)
  const T k = q.k - skew * (q.m + m);  // II(t2, t2)
  residual[0] = scale * q.l / q.e;
  residual[1] = T(std::sqrt(2.0)) * scale * m / sqrt(q.d);
  residual[2] = scale * k * q.e / q.d;
}

/// Two residuals whose squares sum to |grad_S H|^2 |n|.
template <class T>
void variation_residuals(const T* jet, T* residual) {
  using std::sqrt;
  const Forms<T> q = forms(jet);
  const T *su = jet, *sv = jet + 3, *suu = jet + 6, *suv = jet + 9, *svv = jet + 12;
  const T* third = jet + 15;  // Suuu, Suuv, Suvv, Svvv
  // H = a / (2 |n|^3), a = g l - 2 f m + e k
  const T a = q.g * q.l - T(2.0) * q.f * q.m + q.e * q.k;
  const T inverse_d = T(1.0) / q.d;
  const T h_scale = T(0.5) * inverse_d / sqrt(q.d);
  T slope[2];
  for (int w = 0; w < 2; ++w) {
    const T *su_w = w == 0 ? suu : suv, *sv_w = w == 0 ? suv : svv;
    const T* suu_w = third + 3 * w;
    const T* suv_w = third + 3 * (w + 1);
    const T* svv_w = third + 3 * (w + 2);
    T n_w[3];
    for (int c = 0; c < 3; ++c) {
      const int c1 = (c + 1) % 3, c2 = (c + 2) % 3;
      n_w[c] = su_w[c1] * sv[c2] - su_w[c2] * sv[c1] + su[c1] * sv_w[c2] - su[c2] * sv_w[c1];
    }
    const T e_w = T(2.0) * inner(su, su_w), g_w = T(2.0) * inner(sv, sv_w);
    const T f_w = inner(su_w, sv) + inner(su, sv_w);
    const T l_w = inner(n_w, suu) + inner(q.n, suu_w);
    const T m_w = inner(n_w, suv) + inner(q.n, suv_w);
    const T k_w = inner(n_w, svv) + inner(q.n, svv_w);
    const T d_w = T(2.0) * inner(q.n, n_w);
    const T a_w = g_w * q.l + q.g * l_w - T(2.0) * (f_w * q.m + q.f * m_w) + e_w * q.k + q.e * k_w;
    slope[w] = h_scale * (a_w - T(1.5) * a * d_w * inverse_d);
  }
  const T root = sqrt(sqrt(q.d));
  residual[0] = root * slope[0] / sqrt(q.e);
  residual[1] = root * (slope[1] - q.f / q.e * slope[0]) * sqrt(q.e / q.d);
}

}  // namespace bodyline::optimize
