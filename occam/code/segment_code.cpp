#include "occam/code/generator.hpp"

namespace placedpar::occam {

using transputer::Operation;

Storage Generator::locate_segment(const Segment& segment) {
    Storage location = pointer_to(locate(*segment.array));
    const Extent all = outer_extent(location);
    const Type& array = plain(*location.type);
    const std::optional<std::int64_t> from = segment.from ? constant_of(*segment.from) : 0,
                                      count = segment.count ? constant_of(*segment.count) : std::nullopt,
                                      size = fixed_size(*array.element);
    if (array.count)
        location.extents.insert(location.extents.begin(), all);
    Extent& extent = location.extents.front();
    location.type = array_of(*array.element);
    location.is_scalar = false;
    if (!segment.count && from && all.constant)
        extent.constant = *all.constant - *from;
    else if (count)
        extent = {count};
    else
        extent = segment_count(segment, all);
    if (from && size && (all.constant || !options_.range_checks) && (extent.constant || *from == 0)) {
        location.offset += *from * *size;
        return location;
    }
    return move_to_segment(location, segment, all, extent);
}

/// Computes and checks the count of a segment whose count is not constant.
Extent Generator::segment_count(const Segment& segment, const Extent& all) {
    const Extent extent{std::nullopt, temporary()};
    if (segment.count) {
        expression(*segment.count);
        if (options_.range_checks) {
            load_extent(all, 1);
            op(Operation::csub0);
            fails("a segment of {b} elements does not fit in an array of {a-1} elements");
        }
    } else {
        load_extent(all);
        const Cell saved = temporary();
        store(saved);
        expression(*segment.from);
        if (options_.range_checks) {
            load(saved);
            op(Operation::adc, 1);
            op(Operation::csub0);
            fails("a segment begins at element {b} of an array of {a-1} elements");
        }
        load(saved);
        op(Operation::rev);
        op(Operation::sub);
    }
    store(extent.cell);
    return extent;
}

/// Returns the location of a segment of the array at `location`. Generates the code that computes the beginning of the
/// segment, and a check that the segment is inside the array.
Storage Generator::move_to_segment(Storage location, const Segment& segment, const Extent& all, const Extent& extent) {
    const Type& element = *plain(*location.type).element;
    if (segment.from)
        expression(*segment.from);
    else
        constant(0);
    if (options_.range_checks && segment.count) {
        if (all.constant && extent.constant) {
            constant(*all.constant - *extent.constant + 1);
        } else {
            load_extent(extent);
            load_extent(all, 1);
            op(Operation::csub0); // otherwise the next limit could be negative, and csub0 would take it for a large
                                  // number
            fails("a segment of {b} elements does not fit in an array of {a-1} elements");
            load_extent(all, 1);
            op(Operation::rev);
            op(Operation::sub);
        }
        op(Operation::csub0);
        fails("a segment begins at element {b}, but can begin only at elements 0 to {a-1}");
    }
    Storage start = location;
    start.type = &element;
    start.extents.erase(start.extents.begin());
    start.has_index = true;
    start = pointer_to(start);
    start.type = location.type;
    start.extents = location.extents;
    return start;
}

} // namespace placedpar::occam
