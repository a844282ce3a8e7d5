! The Z-chain of Table 1 with its end point held, for AUTO-07p: moments out of balance in the absolute angles, and the
! end point. Unknown are the four angles and the reaction force; PAR(1) is the deflection.
subroutine func(ndim, u, icp, par, ijac, f, dfdu, dfdp)
  implicit none
  integer, intent(in) :: ndim, icp(*), ijac
  double precision, intent(in) :: u(ndim), par(*)
  double precision, intent(out) :: f(ndim)
  double precision, intent(inout) :: dfdu(ndim, ndim), dfdp(ndim, *)
  double precision, parameter :: rest(4) = (/ -0.2417d0, 0.6821d0, -0.7958d0, 0.5170d0 /)
  double precision :: c(4), s(4), torque
  integer :: i
  c = cos(u(1:4))
  s = sin(u(1:4))
  f(1:4) = s * u(5) - c * u(6)
  do i = 1, 4
    torque = u(i) - rest(i)
    if (i > 1) torque = torque - u(i - 1)
    f(i) = f(i) + torque
    if (i > 1) f(i - 1) = f(i - 1) - torque
  end do
  f(5) = sum(c) - (3.8d0 - par(1))
  f(6) = sum(s)
  if (ijac == 0) return
  dfdu = 0d0
  do i = 1, 4
    dfdu(i, i) = 1d0 + c(i) * u(5) + s(i) * u(6)
    if (i < 4) then
      dfdu(i, i) = dfdu(i, i) + 1d0
      dfdu(i, i + 1) = -1d0
      dfdu(i + 1, i) = -1d0
    end if
    dfdu(i, 5) = s(i)
    dfdu(i, 6) = -c(i)
    dfdu(5, i) = -s(i)
    dfdu(6, i) = c(i)
  end do
  if (ijac == 1) return
  dfdp(:, 1) = 0d0
  dfdp(5, 1) = 1d0
end subroutine func

! The unloaded shape; its end point is (3.8, 0) to three places, which the first Newton step mends.
subroutine stpnt(ndim, u, par, t)
  implicit none
  integer, intent(in) :: ndim
  double precision, intent(inout) :: u(ndim), par(*)
  double precision, intent(in) :: t
  u = (/ -0.2417d0, 0.4404d0, -0.3554d0, 0.1616d0, 0d0, 0d0 /)
  par(1) = 0d0
end subroutine stpnt

subroutine bcnd
end subroutine bcnd
subroutine icnd
end subroutine icnd
subroutine fopt
end subroutine fopt
subroutine pvls
end subroutine pvls
