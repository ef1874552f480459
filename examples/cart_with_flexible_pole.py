"""A cart that carries a flexible pole with a mass at its end, stated by its energies. Run: python FILE."""

import casadi as ca

import tmodes


def points(q, p):
    return {"tip": (q.cart + p.length * ca.sin(q.pole), 0, p.length * ca.cos(q.pole)), "cart": (q.cart, 0, 0)}


def kinetic(q, v, p):
    along = v.cart + p.length * ca.cos(q.pole) * v.pole
    up = -p.length * ca.sin(q.pole) * v.pole
    return p.cart_mass * v.cart**2 / 2 + p.tip_mass * (along**2 + up**2) / 2


pole = tmodes.System(
    name="cart_with_flexible_pole",
    coordinates={"cart": "m", "pole": "rad"},
    parameters={"cart_mass": 2.0, "tip_mass": 0.3, "length": 0.5, "stiffness": 20.0, "damping": 0.02},
    kinetic=kinetic,
    gravity=lambda q, p: p.tip_mass * p.g * p.length * ca.cos(q.pole),
    elastic=lambda q, p: p.stiffness * q.pole**2 / 2,
    dissipation=lambda q, v, p: p.damping * v.pole**2 / 2,
    points=points,
)
move = {"type": "trapezoid", "start": 0.0, "end": 0.5, "duration": 1.0, "ramp_fraction": 0.3}
control = {"type": "pd", "position_gain": 800.0, "velocity_gain": 80.0}
robot = pole.robot(
    drives=[{"joint": "cart", "command": "position", "signal": move, "controller": control}],
    integration={"duration": 2.0, "output_step": 0.005},
)

if __name__ == "__main__":
    print(tmodes.run(robot).summary())
