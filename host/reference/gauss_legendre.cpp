// SPDX-License-Identifier: Apache-2.0
// Golub and Welsch, Calculation of Gauss quadrature rules, Math. Comp. 23, 1969.
#include "reference/gauss_legendre.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace gonio::reference {

QuadratureRule gauss_legendre(int count)
{
    // The Jacobi matrix of the Legendre polynomials has k / sqrt(4 k^2 - 1) beside its empty
    // diagonal.
    Eigen::VectorXd beside(count - 1);
    for (int k = 1; k < count; ++k) beside(k - 1) = k / std::sqrt(4.0 * k * k - 1);
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> jacobi;
    jacobi.computeFromTridiagonal(Eigen::VectorXd::Zero(count), beside);
    return {(1 + jacobi.eigenvalues().array()) / 2, jacobi.eigenvectors().row(0).array().square()};
}

}  // namespace gonio::reference
