// SPDX-License-Identifier: Apache-2.0
// Gauss rules, made once.
#include "quadrature/rules.hpp"

#include <map>
#include <mutex>

namespace gonio {

const reference::QuadratureRule& rule_of(int order)
{
    static std::mutex lock;
    static std::map<int, reference::QuadratureRule> rules;
    const std::scoped_lock locked(lock);
    auto found = rules.find(order);
    if (found == rules.end()) found = rules.emplace(order, reference::gauss_legendre(order)).first;
    return found->second;
}

}  // namespace gonio
