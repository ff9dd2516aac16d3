// Methods without cells: a whole order of primitives, taken a batch at a time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/orders/nearest_first.h"
#include "core/run/method.h"

namespace sightline {

/// How many primitives a step takes unless the order says otherwise.
inline constexpr std::uint32_t primitive_batch = 32;

/// An order of primitives as data.
template <int D>
struct PrimitiveOrder {
    /// Empty: all of them, nearest centroid first.
    std::function<std::vector<std::uint32_t>(const Problem<D>&)> primitives;
    bool culls = true;                      ///< leaves out what lies outside the view
    Misses promise = Misses::may;           ///< of the whole order
    std::string_view code;                  ///< "order the primitives, nearest centroid first"
    std::string_view source;                ///< of that line
    std::uint32_t batch = primitive_batch;  ///< primitives of a step; 1: a step pops its primitive
    std::string_view when_empty{};          ///< how an order without a primitive is spoken of
};

template <int D>
class OrderRun final : public Run<D> {
public:
    OrderRun(const Problem<D>& problem, const PrimitiveOrder<D>& order);

    bool restart(const Problem<D>&) override;
    Stop run(std::uint32_t steps, Recorder*) override;
    bool finished() const override;
    bool undoes_by_marks() const override { return true; }
    bool move(Direction, const Step&, std::span<Change>, const Counters& before) override;
    std::uint32_t substeps(const Step&, std::span<const Change>) const override { return 2; }
    void rewind_to(Step&, std::vector<Change>&, const Counters& before, std::uint32_t substep) override;
    std::unique_ptr<Run<D>> clone() const override { return std::make_unique<OrderRun>(*this); }
    std::size_t memory_bytes() const override;
    std::uint64_t hash() const override;
    Misses misses() const override;
    Verdict why_not(const Item& item) const override;
    std::vector<CodeLine> code(const CodePlace&) const override;

private:
    void begin_order();
    Stop batch(Recorder*);
    bool meet_next();

    PrimitiveOrder<D> order_;
    std::vector<std::uint32_t> primitives_;  ///< the order, as far as it is known
    std::uint32_t count_ = 0;                ///< of the whole order
    NearestFirst<D> nearest_;                ///< goes on with the order
    std::vector<Showing> shown_;             ///< of those in it, where it is `nearest_` that tells
};

extern template class OrderRun<2>;
extern template class OrderRun<3>;

template <int D>
Method<D> order_method(std::string_view id, std::string_view title, std::string_view sentence,
                       const PrimitiveOrder<D>& order) {
    Method<D> method{id, title, sentence, [order](const Problem<D>& problem) -> std::unique_ptr<Run<D>> {
                         return std::make_unique<OrderRun<D>>(problem, order);
                     }};
    method.pops = Kind::primitive;
    method.needs.cells = false;
    method.promise = order.promise;
    if (order.culls) method.parameters = {&culled_cost_row()};
    return method;
}

}  // namespace sightline
