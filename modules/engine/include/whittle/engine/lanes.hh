#pragma once

#include "whittle/engine/indexed_mesh.hh"

namespace whittle {

/// Two doubles computed on at once. The same formula on two chains of operations that wait for their own results takes
/// the time of one, and each element gets bit for bit what it would get alone.
using Double2 = double __attribute__((vector_size(16)));
/// What comparing them gives: bool, or one all-ones or zero integer an element.
template <class Real>
using LaneMask = decltype(Real{} > Real{});

}  // namespace whittle
