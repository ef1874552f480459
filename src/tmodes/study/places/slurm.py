"""A Slurm cluster: placeholder"""
