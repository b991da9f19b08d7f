// SPDX-License-Identifier: Apache-2.0
// The algebra of operators that are a diagonal and a kernel; keeping the two apart keeps thin
// layers exact to the last digit.
#include "reference/adding_doubling/light_operator.hpp"

#include <Eigen/LU>
#include <utility>

namespace gonio::reference {

LightOperator specular(Eigen::VectorXd diagonal, Eigen::Index quadrature)
{
    const Eigen::Index size = diagonal.size();
    return {std::move(diagonal), Eigen::MatrixXd::Zero(size, size), quadrature};
}

LightOperator operator+(const LightOperator& a, const LightOperator& b)
{
    return {a.diagonal + b.diagonal, a.kernel + b.kernel, a.quadrature};
}

LightOperator operator*(const Eigen::ArrayXd& mirror, const LightOperator& a)
{
    return {mirror * a.diagonal.array(), mirror.matrix().asDiagonal() * a.kernel, a.quadrature};
}

LightOperator operator*(const LightOperator& a, const LightOperator& b)
{
    LightOperator product{a.diagonal.cwiseProduct(b.diagonal), {}, a.quadrature};
    product.kernel = a.diagonal.asDiagonal() * b.kernel;
    product.kernel += a.kernel * b.diagonal.asDiagonal();
    product.kernel.noalias() += a.kernel.leftCols(a.quadrature) * b.kernel.topRows(a.quadrature);
    return product;
}

LightOperator symmetric_product(const LightOperator& a, const LightOperator& b)
{
    LightOperator product{a.diagonal.cwiseProduct(b.diagonal), {}, a.quadrature};
    product.kernel = a.diagonal.asDiagonal() * b.kernel;
    product.kernel += a.kernel * b.diagonal.asDiagonal();
    product.kernel.triangularView<Eigen::Lower>() +=
        a.kernel.leftCols(a.quadrature) * b.kernel.topRows(a.quadrature);
    product.kernel.triangularView<Eigen::StrictlyUpper>() = product.kernel.transpose();
    return product;
}

LightOperator after_round_trips(const LightOperator& a, const LightOperator& b)
{
    const Eigen::Index quadrature = a.quadrature;
    const Eigen::Index exact = a.diagonal.size() - quadrature;
    // Total reflection on both sides of a lossless layer leaves 0 here: no light comes to such a
    // direction, and any pivot will do.
    const Eigen::VectorXd lost =
        (1 - a.diagonal.array()).unaryExpr([](double x) { return x == 0 ? 1 : x; });

    LightOperator result{b.diagonal.cwiseQuotient(lost), {}, quadrature};
    const Eigen::MatrixXd first = b.kernel + a.kernel * result.diagonal.asDiagonal();
    Eigen::MatrixXd system = -a.kernel.topLeftCorner(quadrature, quadrature);
    system.diagonal() += lost.head(quadrature);
    result.kernel.resize(first.rows(), first.cols());
    result.kernel.topRows(quadrature) = system.partialPivLu().solve(first.topRows(quadrature));
    result.kernel.bottomRows(exact) = first.bottomRows(exact);
    result.kernel.bottomRows(exact).noalias() +=
        a.kernel.bottomLeftCorner(exact, quadrature) * result.kernel.topRows(quadrature);
    result.kernel.bottomRows(exact).array().colwise() /= lost.tail(exact).array();
    return result;
}

Eigen::VectorXd worth_before(const Eigen::VectorXd& worth, const LightOperator& a)
{
    return worth.cwiseProduct(a.diagonal) +
           a.kernel.topRows(a.quadrature).transpose() * worth.head(a.quadrature);
}

}  // namespace gonio::reference
