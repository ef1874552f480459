"""LAW: the equations of motion as pure expressions. Energies and frames are stated; forces are derived."""
