"""PlacedPar simulates networks of transputers, and the CSP processes placed on them.

    import placedpar as pp
    run = pp.load("figure-e2.cfs", slaves=4).run(seed=1)
    run.measures

pandas and NumPy are used if they are installed. Without pandas, tables are lists of dictionaries.
"""

from ._core import version as __version__
from .convergence import convergence
from .errors import (Deadlock, Error, NetlistError, NetlistWarning, ProcessError, ProgramError, RecordError,
                     RecordWarning, RunError)
from .identification import Identification, identify
from .monitor import Monitor
from .network import Drawing, Network, Page, Run, load
from .process import *
from .search import Found, Front, search, search_front
from .study import Explanation, explain, sweep
