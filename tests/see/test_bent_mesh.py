"""The surface of a link that bends: laid about its line, in the page, from a URDF and an STL of the test's own."""

from __future__ import annotations

import struct
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from see.looking import look
from tmodes import load, run
from tmodes.io.mesh_file import box
from tmodes.report import write_report
from tmodes.report.meshes import read_shapes, with_shapes
from tmodes.report.scene import scene_of
from tmodes.result import Result

URDF = """<robot name="rod"><link name="base"/>
<link name="arm"><inertial><origin xyz="0 0 0.5"/><mass value="1"/>
<inertia ixx="0.08" iyy="0.08" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial>
<visual><geometry><mesh filename="arm.stl"/></geometry></visual></link>
<joint name="hinge" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 1 0"/>
<limit lower="-1" upper="1" effort="10" velocity="9"/></joint></robot>"""
ELASTICITY = """format: 1
urdf: rod.urdf
name: rod
links:
  arm:
    beam:
      model: strain
      to: [0, 0, 1.0]
      functions: {twist: 1, bend_y: 2, bend_z: 2}
      mass_per_length: 1.0
      bending_stiffness: 2.0
      torsion_stiffness: 2.0
      damping_time: 1.0e-3
    keep_inertial: replaced
drives:
  - {joint: hinge, command: prescribed, signal: {type: quintic, start: 0.0, end: 1.0, duration: 0.4}}
gravity: [0, 0, 0]
tip: {link: arm, position: [0, 0, 1.0]}
integration: {duration: 0.4, output_step: 0.02}
"""
