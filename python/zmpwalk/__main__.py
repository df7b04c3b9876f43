"""`python -m zmpwalk` is the command `zmpwalk`."""

import sys

from .cli import main

if __name__ == "__main__":
    sys.exit(main())
