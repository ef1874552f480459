"""Studies: many robots of one sheet, planned, run, kept and shown; sensitivities and optimal designs."""
