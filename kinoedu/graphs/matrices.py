"""The matrices of a graph, as scipy sparse arrays.

The graph has n nodes, and m edges numbered as they were added. The row of a node without edges is
zero, as is that of a deleted node.

F. Bullo, "Lectures on Network Systems", chapters 4, 6 and 9.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..geometry.checks import Array

if TYPE_CHECKING:
    from scipy.sparse import csr_array


def adjacency_matrix(
    size: int, edges: NDArray[np.int64], weights: Array, *, directed: bool
) -> csr_array:
    """The adjacency matrix A (n, n): A[u, v] is the weight of the edge from u to v.

    Weights of parallel edges are added. A is symmetric unless the graph is directed. A loop is
    stored on the diagonal once, and an edge of weight zero as a zero.

    Examples
    --------
    >>> adjacency_matrix(2, np.array([(0, 1)]), np.array([5.0]), directed=True).toarray()
    array([[0., 5.],
           [0., 0.]])
    """
    from scipy.sparse import coo_array

    back = edges[edges[:, 0] != edges[:, 1]][:, ::-1] if not directed else edges[:0]
    rows, columns = np.concatenate([edges, back]).T
    values = np.concatenate([weights, weights[edges[:, 0] != edges[:, 1]][: len(back)]])
    return coo_array((values, (rows, columns)), shape=(size, size)).tocsr()


def incidence_matrix(size: int, edges: NDArray[np.int64]) -> csr_array:
    """The incidence matrix B (n, m): B[u, e] is +1 where edge e leaves u and -1 where it arrives.

    The column of a loop is zero. An undirected edge is taken to lead from the first node given to
    the second; either way L = B diag(weights) B^T.

    Examples
    --------
    >>> incidence_matrix(3, np.array([(0, 1), (2, 1)])).toarray()
    array([[ 1.,  0.],
           [-1., -1.],
           [ 0.,  1.]])
    """
    from scipy.sparse import coo_array

    numbers = np.flatnonzero(edges[:, 0] != edges[:, 1])
    signs = np.repeat([1.0, -1.0], len(numbers))
    return coo_array(
        (signs, (edges[numbers].T.ravel(), np.tile(numbers, 2))), shape=(size, len(edges))
    ).tocsr()


def laplacian_matrix(adjacency: csr_array) -> csr_array:
    """The Laplacian matrix L = D - A (n, n), where D is the diagonal matrix of the row sums of A.

    For a directed graph D holds the weights that leave each node. Each row of L sums to zero. For
    an undirected graph L is symmetric, and its kernel has as many dimensions as the graph has
    components. A loop does not change L.

    Examples
    --------
    >>> edge = adjacency_matrix(2, np.array([(0, 1)]), np.array([5.0]), directed=False)
    >>> laplacian_matrix(edge).toarray()
    array([[ 5., -5.],
           [-5.,  5.]])
    """
    from scipy.sparse import diags_array

    return (diags_array(adjacency.sum(axis=1)) - adjacency).tocsr()
