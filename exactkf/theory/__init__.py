# SPDX-License-Identifier: MIT
"""The mathematics of the fast filter and the Riccati equation, over any exact field.

Modules
-------
``szego``            Schur parameters, Szegö polynomials, Toeplitz matrices
``kimura_georgiou``  parametrisation of pairs of polynomials
``fast_filter``      one step in three coordinate systems
``orbits``           orbits and escape
``power_method``     the exact state far ahead, by repeated squaring
``invariants``       the pseudo-polynomial and the invariants it gives
``riccati``          Riccati recursions
``equilibrium``      rational equilibria of the covariance equation
``definiteness``     nonnegative and positive matrices, with witnesses
``hamiltonian``      the semigroup of Hamiltonian matrices
``likelihood``       maximum-likelihood estimation with singular covariance

References
----------
D71    D. J. Duven, Convergence of the difference equation for the error covariance matrix arising in
       Kalman filter theory, thesis, Iowa State University, 1971.
BLM91  C. Byrnes, A. Lindquist, T. McGregor, IEEE Trans. Automat. Control 36 (1991).
NWL92  R. Nikoukhah, A. Willsky, B. Levy, IEEE Trans. Automat. Control 37 (1992).
B93    P. Bougerol, SIAM J. Control Optim. 31 (1993).
BLZ94  C. Byrnes, A. Lindquist, Y. Zhou, SIAM J. Control Optim. 32 (1994).
"""

from exactkf.theory.definiteness import negative_direction, nonpositive_direction
from exactkf.theory.equilibrium import (
    Equilibrium,
    EquilibriumSet,
    equilibria,
    equilibrium_from_basis,
    stabilizing_equilibrium,
)
from exactkf.theory.fast_filter import (
    State,
    ag_from_alpha_gamma,
    ag_from_q,
    alpha_gamma_from_ag,
    alpha_matrix,
    gain,
    gamma_matrix,
    q_from_ag,
    step_ag,
    step_alpha_gamma,
    step_numerators,
    step_polynomials,
    step_q,
)
from exactkf.theory.hamiltonian import (
    Membership,
    from_factors,
    hamiltonian_matrix,
    is_symplectic,
    membership,
    moebius,
    to_factors,
)
from exactkf.theory.invariants import (
    difference_of_squares,
    projective_invariants,
    pseudo_polynomial,
    pseudo_polynomial_from_parameters,
    pseudo_polynomial_from_q,
    scaling_factor,
)
from exactkf.theory.kimura_georgiou import from_kimura_georgiou, laurent_covariances, to_kimura_georgiou
from exactkf.theory.likelihood import (
    error_covariance,
    estimable_part,
    estimate,
    full_rank_factors,
    is_estimable,
    likelihood_blocks,
    likelihood_matrix,
    symmetric_inverse,
)
from exactkf.theory.orbits import IntegerState, Orbit, exact_orbit, first_escape, integer_orbit, orbit
from exactkf.theory.power_method import Arrival, power_modulo, state_after, symplectic_matrix_of
from exactkf.theory.riccati import (
    act,
    covariance_step,
    duven_matrix,
    filter_map,
    observer_form,
    posterior_covariance,
    riccati_gain,
    riccati_step,
    symplectic_matrix,
)
from exactkf.theory.szego import (
    covariance_matrix,
    covariances,
    levinson,
    pi_polynomials,
    prediction_errors,
    reversed_polynomial,
    rho_polynomials,
    schur_parameters,
    second_kind_matrix,
    second_kind_polynomials,
    szego_matrix,
    szego_polynomials,
    toeplitz,
    toeplitz_determinants,
)

__all__ = [
    "Arrival",
    "Equilibrium",
    "EquilibriumSet",
    "IntegerState",
    "Membership",
    "Orbit",
    "State",
    "act",
    "ag_from_alpha_gamma",
    "ag_from_q",
    "alpha_gamma_from_ag",
    "alpha_matrix",
    "covariance_matrix",
    "covariance_step",
    "covariances",
    "difference_of_squares",
    "duven_matrix",
    "equilibria",
    "equilibrium_from_basis",
    "error_covariance",
    "estimable_part",
    "estimate",
    "exact_orbit",
    "filter_map",
    "first_escape",
    "from_factors",
    "from_kimura_georgiou",
    "full_rank_factors",
    "gain",
    "gamma_matrix",
    "hamiltonian_matrix",
    "integer_orbit",
    "is_estimable",
    "is_symplectic",
    "laurent_covariances",
    "levinson",
    "likelihood_blocks",
    "likelihood_matrix",
    "membership",
    "moebius",
    "negative_direction",
    "nonpositive_direction",
    "observer_form",
    "orbit",
    "pi_polynomials",
    "posterior_covariance",
    "power_modulo",
    "prediction_errors",
    "projective_invariants",
    "pseudo_polynomial",
    "pseudo_polynomial_from_parameters",
    "pseudo_polynomial_from_q",
    "q_from_ag",
    "reversed_polynomial",
    "rho_polynomials",
    "riccati_gain",
    "riccati_step",
    "scaling_factor",
    "schur_parameters",
    "second_kind_matrix",
    "second_kind_polynomials",
    "stabilizing_equilibrium",
    "state_after",
    "step_ag",
    "step_alpha_gamma",
    "step_numerators",
    "step_polynomials",
    "step_q",
    "symmetric_inverse",
    "symplectic_matrix",
    "symplectic_matrix_of",
    "szego_matrix",
    "szego_polynomials",
    "to_factors",
    "to_kimura_georgiou",
    "toeplitz",
    "toeplitz_determinants",
]
