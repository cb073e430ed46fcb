# Robot files and the kinematics that they describe.
