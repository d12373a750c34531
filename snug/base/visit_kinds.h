#pragma once

#include <utility>
#include <variant>

namespace snug {

template <class... Cases>
struct OneOf : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
OneOf(Cases...) -> OneOf<Cases...>;

/// Calls the function that takes what the variant holds; a kind without one does not compile.
template <class Variant, class... Cases>
decltype(auto) visit_kinds(Variant&& variant, Cases... cases) {
    return std::visit(OneOf{std::move(cases)...}, std::forward<Variant>(variant));
}

}  // namespace snug
