"""How a run changes with the numbers of the data sheet: sensitivities forwards, gradients by adjoints."""
