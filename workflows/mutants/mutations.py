"""Every single change of a file that a test ought to notice."""

import ast
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

_OPERATORS: dict[type[ast.AST], tuple[type[ast.AST], ...]] = {
    ast.Lt: (ast.LtE, ast.GtE),
    ast.LtE: (ast.Lt, ast.Gt),
    ast.Gt: (ast.GtE, ast.LtE),
    ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
    ast.And: (ast.Or,),
    ast.Or: (ast.And,),
    ast.Add: (ast.Sub,),
    ast.Sub: (ast.Add,),
    ast.Mult: (ast.Div,),
    ast.Div: (ast.Mult,),
    ast.FloorDiv: (ast.Mod,),
    ast.Mod: (ast.FloorDiv,),
    ast.Pow: (ast.Mult,),
    ast.BitAnd: (ast.BitOr,),
}
_REMOVABLE = (ast.Raise, ast.AugAssign, ast.Expr)
_UNTOUCHED_FIELDS = {"annotation", "returns", "decorator_list", "type_params", "bases"}
_UNTOUCHED = (ast.JoinedStr, ast.Raise, ast.Assert, ast.Import, ast.ImportFrom)


class Mutation(NamedTuple):
    """One change: where, the statement before and after, and what finds it again."""

    file: str
    line: int
    last_line: int
    before: str
    after: str
    place: int
    variant: int


class _Place(NamedTuple):
    """A node by its parent's field (and position in it), with the statement it belongs to."""

    parent: ast.AST
    field: str
    position: int | None
    node: ast.AST
    statement: ast.stmt

    def put(self, node: ast.AST) -> None:
        """Replace the node."""
        if self.position is None:
            setattr(self.parent, self.field, node)
        else:
            getattr(self.parent, self.field)[self.position] = node


def mutations(root: Path, file: str) -> list[Mutation]:
    """All mutations of a file, in the order of its text."""
    text = (root / file).read_text("utf-8")
    found = []
    for number, place in enumerate(_places(ast.parse(text))):
        for variant in range(len(_variants(place.node, place))):
            after = _after(_mutated(text, number, variant)[1], variant)
            line, last = place.statement.lineno, _last_line(place.statement)
            found.append(
                Mutation(file, line, last, _header(place.statement), after, number, variant)
            )
    return found


def mutate(root: Path, mutation: Mutation) -> ast.Module:
    """Syntax tree of the changed file."""
    text = (root / mutation.file).read_text("utf-8")
    return _mutated(text, mutation.place, mutation.variant)[0]


def _mutated(text: str, number: int, variant: int) -> tuple[ast.Module, _Place]:
    tree = ast.parse(text)
    place = list(_places(tree))[number]
    place.put(_variants(place.node, place)[variant])
    return ast.fix_missing_locations(tree), place


def _after(place: _Place, variant: int) -> str:
    """The changed statement, of a tree that holds the change."""
    if place.node is not place.statement:
        return _header(place.statement)
    new = _variants(place.node, place)[variant]
    return "removed" if isinstance(new, ast.Pass) else ast.unparse(new)


def _places(tree: ast.Module) -> Iterator[_Place]:
    for statement in tree.body:
        yield from _below(tree, "body", tree.body.index(statement), statement, statement)


def _below(
    parent: ast.AST, field: str, position: int | None, node: ast.AST, statement: ast.stmt
) -> Iterator[_Place]:
    yield _Place(parent, field, position, node, statement)
    if isinstance(node, _UNTOUCHED):
        return
    for name, value in ast.iter_fields(node):
        if name in _UNTOUCHED_FIELDS:
            continue
        many = isinstance(value, list)
        for index, child in enumerate(value if many else [value]):
            if isinstance(child, ast.AST):
                inner = child if isinstance(child, ast.stmt) else statement
                yield from _below(node, name, index if many else None, child, inner)


def _variants(node: Any, place: _Place) -> list[ast.AST]:
    """What may stand in the place of a node."""
    if type(node) in _OPERATORS:
        return [other() for other in _OPERATORS[type(node)]]
    if isinstance(node, ast.Constant):
        return _constants(node.value)
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.Not):
        return [node.operand]
    if isinstance(node, ast.Return) and node.value is not None:
        return [ast.Return(ast.Constant(None)), ast.Return(ast.Constant(0))]
    return _statements(node, place)


def _statements(node: Any, place: _Place) -> list[ast.AST]:
    if isinstance(node, ast.expr) and place.field == "test" and not isinstance(node, ast.Compare):
        return [ast.UnaryOp(ast.Not(), node)]
    if isinstance(node, _REMOVABLE) and not _is_docstring(node):
        return [ast.Pass()]
    return []


def _constants(value: object) -> list[ast.AST]:
    if isinstance(value, bool):
        return [ast.Constant(not value)]
    if isinstance(value, int | float):
        return [ast.Constant(value + 1), ast.Constant(value - 1)]
    return []


def _is_docstring(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)


def _last_line(statement: ast.stmt) -> int:
    """Last line of a statement, of its head if it holds others."""
    body = getattr(statement, "body", None)
    return max(statement.lineno, body[0].lineno - 1) if body else statement.end_lineno or 0


def _header(statement: ast.stmt) -> str:
    """A statement in one line, without those inside it."""
    lines = ast.unparse(statement).splitlines()
    return next((line for line in lines if not line.startswith("@")), lines[0])
