#pragma once

#include <OpenMesh/Core/Mesh/BaseKernel.hh>
#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

#include "whittle/core/attribute.hh"

// The values of an OpenMesh property as real numbers, whatever their type: numbers, and vectors of them.

namespace whittle {

template <class Value>
constexpr std::size_t n_components_of() {
  if constexpr (std::is_arithmetic_v<Value>) {
    return 1;
  } else {
    return OpenMesh::vector_traits<Value>::size_;
  }
}

/// \param one what stands for 1: 255 for colours that are integers
template <class Value>
void get_components(const Value& value, double one, std::span<double> to) {
  if constexpr (std::is_arithmetic_v<Value>) {
    to[0] = static_cast<double>(value) / one;
  } else {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = static_cast<double>(value[i]) / one;
  }
}

/// Rounds to the nearest where the property has integers.
template <class Scalar>
Scalar to_scalar(double number) {
  return static_cast<Scalar>(std::is_integral_v<Scalar> ? std::round(number) : number);
}

template <class Value>
void set_components(std::span<const double> from, double one, Value& value) {
  if constexpr (std::is_arithmetic_v<Value>) {
    value = to_scalar<Value>(from[0] * one);
  } else {
    for (std::size_t i = 0; i < from.size(); ++i) {
      value[i] = to_scalar<std::decay_t<decltype(value[i])>>(from[i] * one);
    }
  }
}

template <class Value>
constexpr double one_of(AttributeKind kind) {
  if constexpr (std::is_arithmetic_v<Value>) {
    return 1;
  } else {
    return kind == AttributeKind::color && std::is_integral_v<typename OpenMesh::vector_traits<Value>::value_type> ? 255
                                                                                                                   : 1;
  }
}

/// A property of a mesh, and what its values mean.
/// \tparam Handle of the elements that have it
template <class Handle>
class PropertyColumn {
 public:
  virtual ~PropertyColumn() = default;

  /// The kind and the number of components; no values.
  const Attribute& attribute() const { return attribute_; }
  virtual void get(const OpenMesh::BaseKernel& mesh, Handle at, std::span<double> to) const = 0;
  virtual void set(OpenMesh::BaseKernel& mesh, Handle at, std::span<const double> from) const = 0;

 protected:
  explicit PropertyColumn(Attribute attribute) : attribute_(std::move(attribute)) {}

 private:
  Attribute attribute_;
};

/// \tparam PropertyHandle such as OpenMesh::HPropHandleT<Vec2f>
template <class Handle, class PropertyHandle>
class TypedColumn final : public PropertyColumn<Handle> {
 public:
  using Value = typename PropertyHandle::Value;

  TypedColumn(const char* name, AttributeKind kind, PropertyHandle property)
      : PropertyColumn<Handle>({.name = name, .kind = kind, .n_components = n_components_of<Value>()}),
        property_(property),
        one_(one_of<Value>(kind)) {}

  void get(const OpenMesh::BaseKernel& mesh, Handle at, std::span<double> to) const override {
    get_components(mesh.property(property_, at), one_, to);
  }
  void set(OpenMesh::BaseKernel& mesh, Handle at, std::span<const double> from) const override {
    set_components(from, one_, mesh.property(property_, at));
  }

 private:
  PropertyHandle property_;
  double one_;
};

}  // namespace whittle
