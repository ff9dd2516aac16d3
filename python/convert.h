// Between Python's values and ours: points, texts as JSON, and arrays that share memory with what owns it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/vec.h"

namespace sightline {

template <int D>
pybind11::tuple point_tuple(const Vec<D>& p) {
    if constexpr (D == 2)
        return pybind11::make_tuple(p.x, p.y);
    else
        return pybind11::make_tuple(p.x, p.y, p.z);
}

/// What Python makes of a text of ours.
inline pybind11::object from_json(const std::string& text) {
    return pybind11::module_::import("json").attr("loads")(text);
}

/// An array over memory that `owner` keeps: no copy, and read-only, since others rely on it.
template <typename T, typename Owner>
pybind11::array_t<T> view_of(const T* data, std::vector<pybind11::ssize_t> shape, std::shared_ptr<Owner> owner,
                             std::vector<pybind11::ssize_t> strides = {}) {
    auto* const kept = new std::shared_ptr<Owner>(std::move(owner));
    const pybind11::capsule capsule(kept, [](void* p) { delete static_cast<std::shared_ptr<Owner>*>(p); });
    pybind11::array_t<T> array(std::move(shape), std::move(strides), data, capsule);
    array.attr("setflags")(pybind11::arg("write") = false);
    return array;
}

/// An array that takes over what is in a vector.
template <typename T>
pybind11::array_t<T> array_of(std::vector<T> values) {
    auto* const kept = new std::vector<T>(std::move(values));
    const pybind11::capsule capsule(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
    return pybind11::array_t<T>({static_cast<pybind11::ssize_t>(kept->size())}, {}, kept->data(), capsule);
}

}  // namespace sightline
