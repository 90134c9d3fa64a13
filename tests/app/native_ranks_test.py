"""Tests mpirun placedpar run --native: the results do not depend on the number of ranks; endings of all kinds."""

import os
import pathlib
import random
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from native_test import SEARCHES, generations_of, results_of
from program import EXAMPLES, PROGRAM
from ranks_test import ENVIRONMENT, MODULE, MPIRUN, ranks_of

RING = EXAMPLES / "csp/deadlock/ring.cfs"
ISLANDS = EXAMPLES / "genetic/islands/islands.cfs"
