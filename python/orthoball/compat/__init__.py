# SPDX-License-Identifier: MIT
"""Names of other programs: the same calls, with exact shapes behind them.

Each module takes the parameter in the form that its model has and says so: `compat.gudhi` alpha
squared, `compat.alphashape` 1/radius, `compat.matlab` the radius. They are imported one by one:
`from orthoball.compat.gudhi import AlphaComplex`.
"""
