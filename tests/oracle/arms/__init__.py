"""An independent Lagrangian of any Chain: energies by plain composition, equations by automatic differentiation."""
