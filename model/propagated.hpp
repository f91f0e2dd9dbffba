#pragma once

namespace bodyline::model {

/// A chain of patches or of curves with the points that its joins determine. Throws as `propagate`.
template <class Chain>
Chain propagated(Chain chain) {
  propagate(chain);
  return chain;
}

}  // namespace bodyline::model
