"""Meshes for pdrun: conversion of finite element meshes, lattices, node sets and reports."""
